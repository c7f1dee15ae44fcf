// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <linelet/powerline/power_line_network.h>
#include <linelet/powerline/power_line_settings.h>

#include "powerline/pieces/candidates.h"
#include "powerline/pieces/growth.h"

namespace linelet::powerline {

/** \brief A line seen at some stage, whatever became of it. */
struct SeenLine {
  Points course;
  double width = 0; ///< standard deviation of its points about it, meters
};

/** \brief The course and width of \a piece. */
SeenLine
seenLine(const Piece& piece);

/** \brief Fills in PowerLineNetwork::unexplained: the stretches of \a lines, at least
 * as long as the shortest wire, whose points got no label. Points must already be
 * labeled. */
void
findUnexplained(PowerLineNetwork& network,
                const std::vector<SeenLine>& lines,
                const Candidates& candidates,
                const PowerLineSettings& settings);

} // namespace linelet::powerline
