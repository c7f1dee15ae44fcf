// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "powerline/fittings/support_site.h"

namespace linelet::powerline {

/** \brief A jumper at a site, and its points there. */
struct SeenJumper {
  Jumper jumper;
  Indices points; ///< of the site
};

/** \brief Finds the jumpers of a site: between the clamps of two wires that leave it in
 * different directions, a chain of points hangs clear of the structure. Sets the clamps
 * of the ends. */
std::vector<SeenJumper>
findJumpers(SupportSite& site, const FittingPriors& priors);

} // namespace linelet::powerline
