// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <linelet/powerline/power_line_network.h>

#include "powerline/fittings/fitting_priors.h"
#include "powerline/fittings/support_site.h"
#include "powerline/pieces/candidates.h"

namespace linelet::powerline {

/** \brief The sites of all pylons that are scanned densely enough to show shapes. */
std::vector<SupportSite>
findSites(const PowerLineNetwork& network,
          const Candidates& candidates,
          const FittingPriors& priors,
          unsigned threads);

} // namespace linelet::powerline
