// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <vector>

#include <linelet/support/points.h>

#include "powerline/spans/wire_with_ends.h"

namespace linelet::powerline {

/** \brief A horizontal line near which the attachment points of one support lie: the
 * crossarm. */
struct Crossarm {
  Eigen::Vector2d center = Eigen::Vector2d::Zero();
  /// Direction of the line, unit length
  Eigen::Vector2d along = Eigen::Vector2d::UnitX();
  double turn = 0;    ///< tangent of the crossarm's angle to the perpendicular of along
  double spread = -1; ///< standard deviation of attachment points off it; < 0: unknown
};

/** \brief Where two wires that face each other meet: their closest approach, near their
 * ends and near the crossarm if one is known.
 *
 * They share one attachment point if the gap is within the uncertainty of models and
 * points; otherwise each stays on its own wire. */
struct Meeting {
  double a = 0, b = 0; ///< place along each model
  double gap = 0;      ///< distance there, meters
  std::array<Point, 2> places = {Point::Zero(), Point::Zero()}; ///< attachment points
};

Meeting
meet(const WireWithEnds& a,
     int side_a,
     const WireWithEnds& b,
     int side_b,
     const Crossarm& arm = {});

/** \brief Pairs ends that face each other across a support, best first. */
void
matchEnds(std::vector<WireWithEnds>& wires);

} // namespace linelet::powerline
