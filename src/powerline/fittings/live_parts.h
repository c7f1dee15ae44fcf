// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "powerline/fittings/support_site.h"

namespace linelet::powerline {

/** \brief Separates what is connected to wires from what is part of a structure: \ref
 * SupportSite::direction, \ref SupportSite::earthed and \ref SupportSite::live.
 * \param[in] threads 0: all */
void
findLiveParts(SupportSite& site, const FittingPriors& priors, unsigned threads);

} // namespace linelet::powerline
