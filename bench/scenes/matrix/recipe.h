// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "lines.h"
#include "scanner.h"
#include "trees.h"
#include "world.h"

namespace linelet::bench::scenes {

/** \brief What a scene of a kind consists of, before anything is built. */
struct Recipe {
  double length = 400, width = 80; ///< of the extent, meters
  ScanPlan scan;
  double wire_density = 5; ///< points per meter of phase in the open
  double beam = 0.15;      ///< radius of a pulse at the objects, meters
  bool aside = false;      ///< returns of wires lie on the axes of their pulses
  ReliefPlan relief;
};

/** \brief Draws the recipe of a kind of scene. */
Recipe
drawRecipe(SceneKind kind, Random& random);

/** \brief Builds what stands in a scene of that kind. */
void
build(World& world, SceneKind kind, const Recipe& recipe, Random& random);

/** \brief Places every \a span or so, from before the extent to beyond it, on a line
 * through \a through with direction \a angle; \a bends are changes of direction in
 * radians, at the second place and those after it. */
std::vector<Point>
linePlaces(const World& world,
           const Point& through,
           double angle,
           double span,
           const std::vector<double>& bends,
           Random& random);

/** \brief A street along x at \a y: houses on both sides, and, where \a wires, poles
 * with wires and service drops. */
void
addStreet(World& world, double y, int line, bool wires, Random& random);

/** \brief Cranes, gantries, pipe bridges, masts, halls, fences and tracks. */
void
addClutter(World& world, Random& random);

} // namespace linelet::bench::scenes
