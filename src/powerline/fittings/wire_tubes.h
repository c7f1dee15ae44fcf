// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "powerline/fittings/support_site.h"

namespace linelet::powerline {

/** \brief Assigns every point near a wire to the nearest end: \ref SupportSite::tube
 * and \ref SupportSite::along. */
void
layTubes(SupportSite& site,
         const PowerLineNetwork& network,
         const FittingPriors& priors);

} // namespace linelet::powerline
