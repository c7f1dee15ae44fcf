// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <linelet/powerline/power_line_network.h>

#include "powerline/pieces/candidates.h"

namespace linelet::powerline {

/** \brief Finds jumpers and insulator strings at the pylons of a network whose points
 * are labeled, and gives them their points. If pylons are scanned too sparsely to show
 * them, nothing changes. */
void
findFittings(PowerLineNetwork& network, const Candidates& candidates, unsigned threads);

} // namespace linelet::powerline
