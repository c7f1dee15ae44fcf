// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "powerline/pieces/piece.h"

namespace linelet::powerline {

/** \brief Where \a piece hangs on a support on its way: the heights are explained much
 * better by two parabolas that meet in a downward kink. Ascending. */
std::vector<double>
findKinks(const Piece& piece, const Points& points);

} // namespace linelet::powerline
