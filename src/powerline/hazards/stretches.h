// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <linelet/powerline/hazards.h>

#include "powerline/hazards/wire_curve.h"

namespace linelet::powerline {

/** \brief Something closer to a wire than a limit: the affected part of the wire, and
 * where. */
struct Approach {
  double from, to; ///< of the wire
  double distance; ///< least
  double along;    ///< where on the wire it is least
  Point place;
};

/** \brief The approach of \a place to \a curve; to < from if it stays beyond \a limit.
 */
Approach
approach(const WireCurve& curve, const Point& place, double limit);

/** \brief Merges approaches of one kind to a wire and appends the stretches, complete
 * except for ids, to \a out. */
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
