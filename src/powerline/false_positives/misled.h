// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "powerline/pieces/growth.h"
#include "powerline/spans/wire_with_ends.h"

namespace linelet::powerline {

/** \brief Drops wires whose attachment points do not fit their points: too close
 * together, or off the wire. Remnants of a span beyond a pole look like this.
 * \return whether there were any */
bool
dropMisled(std::vector<WireWithEnds>& wires, Growth& growth);

} // namespace linelet::powerline
