// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "plot.h"
#include "world.h"

namespace linelet::bench::scenes {

/** \brief Size of a house, meters; its ridge runs along its length. */
struct House {
  double half_length, half_width;
  double eaves; ///< height above its base
};

/** \brief A dwelling with a gabled roof, eaves, chimney and sometimes an aerial. */
House
addHouse(World& world, const Plot& plot, Random& random);

/** \brief A long hall: flat with a parapet, or with several ridges. */
void
addHall(World& world, const Plot& plot, Random& random);

void
addCrane(World& world, const Plot& plot, Random& random);

/** \brief Two legs and a truss across, as over roads and tracks. */
void
addGantry(World& world, const Plot& plot, Random& random);

/** \brief Pipes on trestles. */
void
addPipeBridge(World& world, const Plot& plot, double length, Random& random);

/** \brief A slim guyed mast. */
void
addGuyedMast(World& world, const Plot& plot, Random& random);

/** \brief Posts and rails, on the ground. */
void
addFence(World& world, const Plot& plot, double length, Random& random);

/** \brief A pair of rails, on the ground. */
void
addTrack(World& world, const Plot& plot, double length);

} // namespace linelet::bench::scenes
