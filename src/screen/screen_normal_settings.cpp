// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/screen/screen_normal_settings.h>

#include <stdexcept>
#include <string>

#include <linelet/support/text.h>

namespace linelet {

void
validate(const ScreenNormalSettings& settings)
{
  if (settings.samples != 5 && settings.samples != 9 && settings.samples != 17 &&
      settings.samples != 25)
    throw std::invalid_argument("samples of a normal must be 5, 9, 17 or 25, not " +
                                std::to_string(settings.samples));
  if (!(settings.max_distance >= 0))
    throw std::invalid_argument("the distance limit " + textOf(settings.max_distance) +
                                " of normals is negative");
}

} // namespace linelet
