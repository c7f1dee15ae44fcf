// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <linelet/powerline/hazards.h>

#include "powerline/hazards/wire_curve.h"

namespace linelet::powerline {

/** \brief Something nearer to a wire than a limit: the part of the wire for which that
 * is so, and the place. */
struct Approach {
  double from, to; ///< of the wire
  double distance; ///< least
  double along;    ///< where on the wire it is least
  Point place;
};

/** \brief The approach of \a place to \a curve; to < from where it stays beyond
 * \a limit. */
Approach
approach(const WireCurve& curve, const Point& place, double limit);

/** \brief Unites approaches to a wire of one kind and appends the stretches, with all
 * that follows from them, but for ids, to \a out. */
void
appendStretches(const PowerLineNetwork& network,
                const WireCurve& curve,
                const Wire& wire,
                HazardKind kind,
                int other,
                const ClearanceLimits& limits,
                std::vector<Approach> approaches,
                std::vector<Encroachment>& out);

} // namespace linelet::powerline
