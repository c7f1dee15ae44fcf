// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "powerline/fittings/support_site.h"

namespace linelet::powerline {

/** \brief Gathers the ends of wires at pylons, and pylons whose surroundings overlap,
 * without the points there. */
std::vector<SupportSite>
gatherSites(const PowerLineNetwork& network, const FittingPriors& priors);

} // namespace linelet::powerline
