// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "corridor_scene.h"

namespace linelet::bench::corridor {

/** \brief How a wire hangs between two attachments. */
struct WireParameters {
  double a = 1000;        ///< catenary constant, meters
  double wind = 0;        ///< swung out of the vertical, degrees
  double radius = 0.0135; ///< of the wire
  double front_string = 0,
         back_string = 0; ///< insulators in line with the wire, meters
};

/** \brief Adds a wire between two attachments, and the members that a beam can hit. */
void
addWire(Scene& scene,
        CorridorWire wire,
        const Point& from,
        const Point& to,
        const WireParameters& parameters);

/** \brief A lattice of \a bays between two squares (four corners each). */
void
addLattice(Scene& scene,
           const Point (&bottom)[4],
           const Point (&top)[4],
           int bays,
           double radius,
           std::uint8_t classification);

/** \brief Removes wire members, so that stretches of wire give no returns. */
void
addGaps(Scene& scene, double per_kilometer, Random& random);

} // namespace linelet::bench::corridor
