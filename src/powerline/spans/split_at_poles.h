// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "powerline/pieces/growth.h"
#include "powerline/spans/wire_with_ends.h"

namespace linelet::powerline {

/** \brief Splits low wires where a pole stands below them: in a dip of the terrain a
 * line passes its poles without a kink. Parts that protrude beyond the last pole are
 * cut off. */
void
splitAtPoles(std::vector<WireWithEnds>& wires, Growth& growth, unsigned threads);

} // namespace linelet::powerline
