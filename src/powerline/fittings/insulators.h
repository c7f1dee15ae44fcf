// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "powerline/fittings/jumpers.h"

namespace linelet::powerline {

/** \brief A string at a site, and its points there. */
struct SeenString {
  InsulatorString string;
  int end = -1;    ///< of a wire that it holds
  int jumper = -1; ///< index in the list of jumpers
  Indices points;  ///< of the site
};

/** \brief Finds the insulator strings of a site: what lies between the structure and
 * the clamp of a jumper, and what is straight and steep between the structure and a
 * wire, or a jumper, below it. */
std::vector<SeenString>
findInsulators(const SupportSite& site,
               const std::vector<SeenJumper>& jumpers,
               const FittingPriors& priors);

} // namespace linelet::powerline
