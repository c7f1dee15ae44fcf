// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "powerline/fittings/support_site.h"

namespace linelet::powerline {

/** \brief Finds for every end of a wire where the structure ends and its string begins:
 * \ref WireEnd::earthed. The part of a string close to the structure becomes live. */
void
findStringEnds(SupportSite& site, const FittingPriors& priors);

} // namespace linelet::powerline
