// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <linelet/curves/curve_network.h>
#include <linelet/powerline/power_line_settings.h>

#include "powerline/pieces/candidates.h"
#include "powerline/pieces/growth.h"
#include "powerline/spans/wire_with_ends.h"
#include "powerline/terrain/underside.h"

namespace linelet::powerline {

/** \brief Extends wires across gaps as far as those beside them reach. */
void
completeByCompany(std::vector<WireWithEnds>& wires,
                  Growth& growth,
                  const PowerLineSettings& settings);

/** \brief Adds wires that are short because the data ends: they continue another wire,
 * or run beside one. */
void
addStubs(std::vector<WireWithEnds>& wires,
         Growth& growth,
         const std::vector<Seed>& seeds,
         const std::vector<Curve>& curves,
         const Underside& underside,
         bool terrain,
         const PowerLineSettings& settings);

} // namespace linelet::powerline
