// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <linelet/powerline/hazards.h>
#include <linelet/powerline/surroundings.h>

#include "powerline/hazards/wire_curve.h"

namespace linelet::powerline {

/** \brief Trees that would reach a wire by falling, smallest gap first.
 *
 * A tree is a local maximum of the canopy within half a crown's width, which grows with
 * its height as 2.51503 + 0.00901 h^2 meters (Popescu and Wynne 2004, eq. 4: pines and
 * deciduous trees). */
std::vector<FallIn>
findFallIn(const PowerLineNetwork& network,
           const std::vector<WireCurve>& curves,
           const Surroundings& surroundings,
           const ClearanceLimits& limits,
           unsigned threads);

} // namespace linelet::powerline
