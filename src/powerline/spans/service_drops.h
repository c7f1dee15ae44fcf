// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <linelet/powerline/power_line_settings.h>

#include "powerline/pieces/candidates.h"
#include "powerline/pieces/growth.h"
#include "powerline/spans/wire_with_ends.h"

namespace linelet::powerline {

/** \brief Adds what leads from a support of a low line to a house and shows on too
 * short a stretch to be told by itself. Its length counts from that support. Ends must
 * have been matched, and have to be again.
 * \return whether there were any */
bool
addServiceDrops(std::vector<WireWithEnds>& wires,
                Growth& growth,
                const std::vector<Seed>& seeds,
                const PowerLineSettings& settings);

/** \brief Carries service drops on to the house that they lead to, as far as it is
 * certain where they hang. */
void
carryDropsHome(std::vector<WireWithEnds>& wires, const Growth& growth);

} // namespace linelet::powerline
