// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <linelet/powerline/network_part.h>

namespace linelet::powerline {

/** \brief Adds to \a network the jumpers and insulators of all parts, each from the one
 * that owns its middle, in the order of the supports; \a ids map the wires and supports
 * of the parts to those of the whole. */
void
joinFittings(const std::vector<NetworkPart>& parts,
             const std::vector<PartIds>& ids,
             PowerLineNetwork& network);

/** \brief Puts jumpers and insulators of \a network in the order of their supports and
 * places, and numbers them. */
void
numberFittings(PowerLineNetwork& network);

} // namespace linelet::powerline
