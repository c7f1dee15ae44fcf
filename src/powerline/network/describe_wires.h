// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <linelet/powerline/power_line_network.h>
#include <linelet/powerline/power_line_settings.h>

#include "powerline/pieces/growth.h"
#include "powerline/spans/wire_with_ends.h"

namespace linelet::powerline {

/** \brief Fits the catenary of \a wire to its members, which are indices in \a points,
 * and to its attachment points, and measures it. */
void
fitWire(Wire& wire, const WireWithEnds& with_ends, const Points& points);

/** \brief Fits the catenary of every wire and fills in what describes it: end points,
 * points, rms, lengths, sag, largest gap, supports, confidence. Ids follow the order of
 * \a wires; spans and numbers come with \ref numberWires. */
std::vector<Wire>
describeWires(const std::vector<WireWithEnds>& wires,
              Growth& growth,
              const PowerLineSettings& settings);

} // namespace linelet::powerline
