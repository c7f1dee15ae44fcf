// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "powerline/pieces/piece.h"

namespace linelet::powerline {

/** \brief Where \a piece passes a support: two parabolas that meet in a downward kink
 * explain the heights much better there. Ascending. */
std::vector<double>
findKinks(const Piece& piece, const Points& points);

} // namespace linelet::powerline
