// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <linelet/powerline/ground.h>
#include <linelet/powerline/power_line_network.h>
#include <linelet/powerline/power_line_settings.h>

#include "powerline/pieces/candidates.h"

namespace linelet::powerline {

/** \brief The minimum height of a wire above the terrain, sampled every meter; unknown
 * without terrain. */
Clearance
lowestAboveGround(const Catenary& curve, const Ground& ground);

/** \brief Measures the clearances of every wire. Vegetation is anything above ground
 * that has neighbors and is neither wire nor support. */
void
measureClearances(PowerLineNetwork& network,
                  const Candidates& candidates,
                  const PowerLineSettings& settings);

} // namespace linelet::powerline
