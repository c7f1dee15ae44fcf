// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "commands.h"

namespace linelet::apps {

const std::vector<Command>&
commands()
{
  static const std::vector<Command> all = {
  };
  return all;
}

} // namespace linelet::apps
