// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <linelet/powerline/power_line_network.h>

#include "powerline/pieces/growth.h"
#include "powerline/spans/wire_with_ends.h"
#include "powerline/supports/tower.h"

namespace linelet::powerline {

/** \brief Gives every point its class, wire and span. */
void
labelPoints(PowerLineNetwork& network,
            const Points& points,
            const std::vector<WireWithEnds>& with_ends,
            const std::vector<int>& ids,
            const std::vector<Tower>& towers,
            const Growth& growth);

} // namespace linelet::powerline
