// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <linelet/powerline/ground.h>

#include "powerline/joints.h"

namespace linelet::powerline {

constexpr double flattest = 1e-4; ///< z2 of a wire, 1/meters: a = 5 km

/** \brief z2 of a wire as its points alone have it, without the prior of the fit. */
struct Bend {
  double value = 0;
  double spread = 1; ///< standard deviation

  /** \brief Whether the points rule out a bend of \a least. */
  bool
  rulesOut(double least) const
  {
    return value + 2.5 * spread < least;
  }

  bool
  isAbove(double least) const
  {
    return value - 2.5 * spread > least;
  }
};

Bend
bendOf(const Piece& piece, const Points& points);

/** \brief Drops what is long and thin but no wire: what is too straight even for a taut
 * one (jibs, ridges, pipes), fences, edges and railings of roofs, crossarms. Their
 * points become free. \a points is the whole cloud. */
void
dropFalsePositives(std::vector<WireWithEnds>& wires,
                   Growth& growth,
                   const Points& points,
                   const Ground& ground);

/** \brief Makes the points of \a wire free. */
void
release(const WireWithEnds& wire, Growth& growth);

} // namespace linelet::powerline
