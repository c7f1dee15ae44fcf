// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <linelet/powerline/clearance_limits.h>
#include <linelet/support/points.h>
#include <linelet/support/visibility.h>

namespace linelet {
namespace LINELET_PUBLIC powerline {

/** \brief What stands near the lines: classified points that are not ground, a wire, or
 * a support of that wire's own line. Found once and used for every state of the wires.
 */
struct Surroundings {
  Points points;
  std::vector<HazardKind> kinds; ///< Vegetation, Building or Support
  std::vector<int> support;      ///< id of the support it belongs to, or 0
};

} // namespace powerline
} // namespace linelet
