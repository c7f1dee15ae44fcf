// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <linelet/powerline/power_line_network.h>

#include "powerline/spans/wire_with_ends.h"

namespace linelet::powerline {

/** \brief Gathers wires into spans and spans into lines, numbers everything, and sorts
 * wires and spans of \a network, whose supports are known, by line, span and wire.
 * \return for every wire of \a with_ends its id */
std::vector<int>
numberWires(PowerLineNetwork& network, const std::vector<WireWithEnds>& with_ends);

} // namespace linelet::powerline
