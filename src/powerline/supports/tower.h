// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <utility>
#include <vector>

#include "powerline/spans/joints.h"

namespace linelet::powerline {

constexpr double lowest_pylon = 12; ///< meters; lower supports are poles

/** \brief A pylon or pole: where wires end, and the points that stand there. */
struct Tower {
  std::vector<std::pair<int, int>> ends; ///< wire, side
  Crossarm arm;                          ///< its center is the axis of the tower
  double base = 0;                       ///< height of the terrain
  double top = 0;                        ///< height of the highest point
  double lowest_arm = 0;                 ///< height of the lowest attachment point
  double half_width = 0;                 ///< of the body at the lowest arm, meters
  double flare = 0;                      ///< growth of half_width per meter downward
  double turn = 0;                       ///< change of direction of the line, degrees
  double reach = 0;  ///< largest distance of an attachment point from the axis
  bool pole = false; ///< all points near one axis
  bool seen = false; ///< it has points; otherwise inferred from the wires alone
  double confidence = 1;
};

} // namespace linelet::powerline
