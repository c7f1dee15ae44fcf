// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <linelet/powerline/network_part.h>
#include <linelet/powerline/power_line_network.h>

#include "powerline/spans/wire_with_ends.h"

namespace linelet::powerline {

/** \brief What merging needs from \a network, whose wires are \a with_ends.
 * \param[in] unnumbered the wires as they were described, in that order
 * \param[in] ids of these in the network
 * \param[in] points to which their members refer */
NetworkPart
partOf(const PowerLineNetwork& network,
       const std::vector<WireWithEnds>& with_ends,
       std::vector<Wire> unnumbered,
       const std::vector<int>& ids,
       const Points& points);

/** \brief \a loose with its ends, as it was; its members are its own points. */
WireWithEnds
hungAgain(const LooseWire& loose);

} // namespace linelet::powerline
