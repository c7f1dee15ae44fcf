// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <linelet/curves/curve_network.h>
#include <linelet/powerline/power_line_settings.h>

#include "powerline/pieces/candidates.h"
#include "powerline/pieces/growth.h"
#include "powerline/spans/wire_with_ends.h"
#include "powerline/terrain/underside.h"

namespace linelet::powerline {

/** \brief Adds wires that lead from a low line to a house and are visible for too short
 * a stretch to be recognized on their own, from seeds and along curves. Their length
 * counts from that line. Ends must be matched before, and again afterward.
 * \param[in] terrain whether the cloud shows terrain: wires then hang clear of what is
 * below
 * \return whether there were any */
bool
addServiceDrops(std::vector<WireWithEnds>& wires,
                Growth& growth,
                const std::vector<Seed>& seeds,
                const std::vector<Curve>& curves,
                const Underside& underside,
                bool terrain,
                const PowerLineSettings& settings);

/** \brief Extends service drops to the house that they lead to, as far as their
 * position is certain. */
void
carryDropsHome(std::vector<WireWithEnds>& wires, const Growth& growth);

} // namespace linelet::powerline
