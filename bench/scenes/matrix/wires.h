// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "world.h"

namespace linelet::bench::scenes {

/** \brief A wire or bundle between two attachments. */
struct Strung {
  WireKind kind = WireKind::Conductor;
  int line = 0, span = 0, number = 0;
  int conductors = 1;
  double spacing = 0.4;    ///< of neighboring conductors of a bundle, meters
  double a = 1000;         ///< catenary constant, meters
  double share = 1;        ///< of the scene's points per meter
  double front_string = 0; ///< insulators in line with the wire, meters
  double back_string = 0;
  double hidden = 0; ///< share of its length without returns
};

/** \brief Hangs a wire or bundle from \a from to \a to. */
void
addWire(World& world,
        const Strung& wire,
        const Point& from,
        const Point& to,
        Random& random);

/** \brief The place at \a share of the span of a catenary with the constant \a a. */
Point
hangingPoint(const Point& from, const Point& to, double a, double share);

} // namespace linelet::bench::scenes
