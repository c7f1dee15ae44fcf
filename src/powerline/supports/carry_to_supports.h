// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <linelet/powerline/power_line_settings.h>

#include "powerline/pieces/growth.h"
#include "powerline/spans/wire_with_ends.h"
#include "powerline/supports/tower.h"
#include "powerline/terrain/underside.h"

namespace linelet::powerline {

/** \brief Extends wires, through what hides them, to the support of those beside them,
 * as far as their position is certain: no wire ends in midair. */
void
carryBesideCompany(std::vector<WireWithEnds>& wires,
                   const std::vector<Tower>& towers,
                   const Growth& growth,
                   const Underside& underside,
                   const PowerLineSettings& settings);

} // namespace linelet::powerline
