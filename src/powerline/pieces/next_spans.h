// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <linelet/powerline/power_line_settings.h>
#include <linelet/support/progress_monitor.h>

#include "powerline/pieces/growth.h"
#include "powerline/terrain/underside.h"

namespace linelet::powerline {

/** \brief Searches for the next span of every wire that ends inside the data without a
 * continuation: a line does not end at its support. Directions are tried from there,
 * and the best are grown, and accepted if their evidence stands out from all that were
 * tried.
 *
 * Finds wires that no neighborhood shows, such as those in crowns with a point per
 * meter or less: a known end leaves few places to search, and evidence along a
 * direction is stronger than that in a ball. New wires are appended to \a wires and own
 * their points. */
void
addNextSpans(Growth& growth,
             std::vector<Piece>& wires,
             const Underside& underside,
             const PowerLineSettings& settings,
             ProgressMonitor* monitor);

} // namespace linelet::powerline
