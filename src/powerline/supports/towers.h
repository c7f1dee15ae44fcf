// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <linelet/powerline/ground.h>
#include <linelet/powerline/power_line_settings.h>

#include "powerline/pieces/growth.h"
#include "powerline/spans/wire_with_ends.h"
#include "powerline/supports/tower.h"

namespace linelet::powerline {

/** \brief Gathers wire ends into supports, finds the structures there, and settles the
 * attachment points: wires that meet share theirs, the others are extended to the
 * crossarm. Ends without a partner or structure are unchanged. */
std::vector<Tower>
buildTowers(std::vector<WireWithEnds>& wires,
            const Growth& growth,
            const Ground& ground,
            const PowerLineSettings& settings);

} // namespace linelet::powerline
