// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <linelet/powerline/power_line_network.h>
#include <linelet/powerline/power_line_settings.h>

#include "powerline/evidence.h"
#include "powerline/towers.h"

namespace linelet::powerline {

/** \brief Fits the catenary of \a wire to its members, which are places in \a points,
 * and to its attachment points, and measures it. */
void
fitWire(Wire& wire, const WireWithEnds& with_ends, const Points& points);

/** \brief Fits the catenary of every wire and fills in what describes it: end points,
 * points, rms, lengths, sag, largest gap, supports, confidence. Ids follow the order of
 * \a wires; spans and numbers come with \ref numberWires. */
std::vector<Wire>
describeWires(const std::vector<WireWithEnds>& wires,
              Growth& growth,
              const PowerLineSettings& settings);

/** \brief The supports that \a towers are, with ids in their order. */
std::vector<Support>
describeSupports(const std::vector<Tower>& towers, bool has_terrain);

/** \brief Gathers wires into spans and spans into lines, numbers everything, and puts
 * wires and spans of \a network, whose supports are known, in order (line, span, wire).
 * \return for every wire of \a with_ends its id */
std::vector<int>
numberWires(PowerLineNetwork& network, const std::vector<WireWithEnds>& with_ends);

/** \brief Gives every point its class, wire and span. */
void
labelPoints(PowerLineNetwork& network,
            const Points& points,
            const std::vector<WireWithEnds>& with_ends,
            const std::vector<int>& ids,
            const std::vector<Tower>& towers,
            const Growth& growth);

/** \brief The least height of a wire above the terrain, by places a meter apart; not
 * known where the terrain is not. */
Clearance
lowestAboveGround(const Catenary& curve, const Ground& ground);

/** \brief Measures the clearances of every wire. Vegetation is what stands above
 * ground, has company, and is neither wire nor support. */
void
measureClearances(PowerLineNetwork& network,
                  const Candidates& candidates,
                  const PowerLineSettings& settings);

} // namespace linelet::powerline
