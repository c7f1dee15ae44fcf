// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <utility>
#include <vector>

#include <linelet/powerline/ground.h>

#include "powerline/candidates.h"
#include "powerline/joints.h"

namespace linelet::powerline {

constexpr double lowest_pylon = 12; ///< meters, lines on lower supports hang from poles

/** \brief A pylon or pole: where wires end, and the points that stand there. */
struct Tower {
  std::vector<std::pair<int, int>> ends; ///< wire, side
  Crossarm arm;                          ///< its center is the axis of the tower
  double base = 0;                       ///< height of the terrain
  double top = 0;                        ///< height of the highest point
  double lowest_arm = 0;                 ///< height of the lowest attachment point
  double half_width = 0;                 ///< of the body at the lowest arm, meters
  double flare = 0;                      ///< growth of half_width per meter downwards
  double turn = 0;                       ///< change of direction of the line, degrees
  double reach = 0;  ///< largest distance of an attachment point from the axis
  bool pole = false; ///< all points near one axis
  bool seen = false; ///< points stand there; else inferred from the wires alone
  double confidence = 1;
};

/** \brief Gathers wire ends into supports, finds the structures there, and settles the
 * attachment points: wires that meet share theirs, the others are carried on to the
 * crossarm. Ends without partner and structure stay as they are. */
std::vector<Tower>
buildTowers(std::vector<WireWithEnds>& wires,
            const Growth& growth,
            const Ground& ground,
            const PowerLineSettings& settings);

/** \brief Whether a point is part of the body or the crossarms of \a tower. */
bool
belongsTo(const Tower& tower, const std::vector<WireWithEnds>& wires, const Point& p);

/** \brief Finds body, axis and top of \a tower among the points \a near (candidates
 * that no wire owns). Sets seen, pole, top, half_width, flare and the center of arm. */
void
findStructure(Tower& tower, const Points& points, const Indices& near);

/** \brief Fits the crossarm of \a tower to its attachment points. */
void
fitCrossarm(Tower& tower, const std::vector<WireWithEnds>& wires);

/** \brief Moves the crossarm of \a tower along the line to where its wires, all
 * together, bend most clearly: in a dip of the terrain, each by itself tells little. */
void
moveToKink(Tower& tower, const std::vector<WireWithEnds>& wires, const Points& points);

} // namespace linelet::powerline
