// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "wires.h"
#include "world.h"
#include "world_lattice.h"

namespace linelet::bench::scenes {

/** \brief A place on a crossarm where a conductor is attached. */
struct Arm {
  double offset, height; ///< across the line; above the lowest arm
};

enum class SupportStyle { Lattice, Wood };

/** \brief A line from support to support. */
struct LinePlan {
  int number = 0;
  std::vector<Point> places; ///< x and y of the supports
  SupportStyle style = SupportStyle::Lattice;
  double scale = 1;       ///< of lattices; 1: 110 kV
  double arm_height = 20; ///< of the lowest arm above the ground
  std::vector<Arm> arms;
  double insulator = 1.5; ///< 0: the wire lies on top of the arm
  WireKind kind = WireKind::Conductor;
  int conductors = 1;
  double spacing = 0.4;
  double a = 1100;
  int earth_wires = 1;
  double peak = 9;      ///< above the lowest arm
  double clearance = 7; ///< of the lowest wire above the ground, at least
  double hidden = 0;
};

/** \brief Arms of a pylon with six conductors, one of three arrangements. */
void
drawTower(LinePlan& plan, double voltage, Random& random);

/** \brief Supports and wires of a line; the supports are raised until the wires clear
 * the ground.
 * \return tops of the supports (at the lowest arm) */
std::vector<Point>
addLine(World& world, const LinePlan& plan, Random& random);

} // namespace linelet::bench::scenes
