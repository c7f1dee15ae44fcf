// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <vector>

namespace linelet {

/** \brief How far the open ends of a curve look for others to be joined to. */
struct EndReach {
  double distance = 0; ///< to another curve
  double loop = 0; ///< along its own curve: closer places are no meeting with itself
};

/** \brief For each curve, of its front and back end. */
using EndReaches = std::vector<std::array<EndReach, 2>>;

} // namespace linelet
