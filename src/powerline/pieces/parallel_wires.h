// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <linelet/powerline/power_line_settings.h>

#include "powerline/pieces/growth.h"

namespace linelet::powerline {

/** \brief Searches for more wires of the same shape beside those found: in a sparse
 * scan, two conductors a few meters apart form no line around any of their points. */
void
addParallelWires(Growth& growth,
                 std::vector<Piece>& pieces,
                 const PowerLineSettings& settings);

} // namespace linelet::powerline
