// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <linelet/powerline/hazards.h>

#include "powerline/hazards/wire_curve.h"

namespace linelet::powerline {

/** \brief Appends the stretches where wires of different lines are closer to each other
 * than the limit, each pair once, for the higher of the two. */
void
appendWiresOfOtherLines(const PowerLineNetwork& network,
                        const std::vector<WireCurve>& curves,
                        const ClearanceLimits& limits,
                        std::vector<Encroachment>& out);

/** \brief All places where wires of different lines cross in plan, without ids. */
std::vector<Crossing>
findCrossings(const PowerLineNetwork& network,
              const std::vector<WireCurve>& curves,
              const ClearanceLimits& limits);

/** \brief Whether a wire belongs to a line that stands on \a support. */
bool
isOwnSupport(const PowerLineNetwork& network, const Wire& wire, int support);

} // namespace linelet::powerline
