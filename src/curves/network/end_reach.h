// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <vector>

namespace linelet {

/** \brief How far the open ends of a curve look for others to be joined to. */
struct EndReach {
  double distance = 0; ///< to another curve
  double loop = 0; ///< along its own curve: closer places are not a meeting with itself
};

/** \brief By curve: of its front and of its back end. */
using EndReaches = std::vector<std::array<EndReach, 2>>;

} // namespace linelet
