// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "plot.h"
#include "world.h"

namespace linelet::bench::scenes {

enum class TreeStyle { Broadleaf, Conifer };

/** \brief A tree: trunk, branches, and leaves around them. */
void
addTree(World& world,
        const Point& base,
        double height,
        double crown_radius,
        TreeStyle style,
        Random& random);

/** \brief A low shrub. */
void
addBush(World& world, const Point& base, Random& random);

/** \brief A row of shrubs. */
void
addHedge(World& world, const Plot& plot, double length, Random& random);

/** \brief Location and density of a wood. */
struct ForestPlan {
  double spacing = 5; ///< of the trees, meters
  double low = 14, high = 26;
  double cutting = 0;      ///< width of the treeless strip about the x axis
  double overhang = 0;     ///< share of the trees beside the cutting that lean over it
  double understory = 0.3; ///< bushes per tree
  double from = -1e9;      ///< along x
  double to = 1e9;
  int side = 0; ///< of the cutting, 1 or -1; 0: both
};

/** \brief Trees with closed canopy, all over the extent except the cutting. */
void
addForest(World& world, const ForestPlan& plan, Random& random);

/** \brief Trees in the open, lone and in groves; below and beside wires they are
 * trimmed now and then, not always in time.
 * \param[in] per_hectare how many of each */
void
scatterTrees(World& world,
             double per_hectare,
             double bushes_per_hectare,
             Random& random);

} // namespace linelet::bench::scenes
