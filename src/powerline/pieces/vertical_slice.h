// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "powerline/pieces/candidates.h"
#include "powerline/pieces/growth.h"

namespace linelet::powerline {

/** \brief A free candidate near the vertical surface below a wire. */
struct Below {
  double s, t, drop; ///< along, across, below the wire, meters
  double depth;      ///< of the lowest possible candidate
};

constexpr double level = 0.5; ///< meters above and below a wire that count as level
constexpr double pole_radius = 0.4; ///< meters
constexpr double least_piece = 6;   ///< meters between poles, and of a wire beyond one
constexpr double clear_from = 0.9,
                 /// Meters from a pole, along the wire, that must be clear
    clear_to = 2.0;

/** \brief Mean height of \a wire above ground. */
double
heightOf(const Piece& wire, const Candidates& candidates);

/** \brief The free candidates below \a wire, and level with it. */
std::vector<Below>
verticalSliceOf(const Piece& wire, const Growth& growth);

/** \brief Where a pole stands below a wire, with hardly anything beside it: positions
 * along the wire, ascending, from its vertical slice. */
std::vector<double>
findColumns(const std::vector<Below>& vertical_slice);

} // namespace linelet::powerline
