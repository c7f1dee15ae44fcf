// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>
#include <vector>

#include <linelet/curves/curve_network.h>
#include <linelet/powerline/power_line_settings.h>
#include <linelet/support/progress_monitor.h>

#include "powerline/pieces/candidates.h"
#include "powerline/pieces/growth.h"

namespace linelet::powerline {

/** \brief The curves of \a candidates, the longest first. */
std::vector<Curve>
curvesOf(const Candidates& candidates,
         const PowerLineSettings& settings,
         ProgressMonitor* monitor);

/** \brief Calls \a visit with the parts of \a curves that hang between two supports,
 * fitted to the free candidates beside them, one by one: what \a visit claims is not
 * free for the next.
 *
 * A point belongs to the nearest of the curves. They are cut where two parabolas
 * explain their points better than one does (Bayesian information criterion). */
void
forEachPieceAlong(const std::vector<Curve>& curves,
                  const Growth& growth,
                  unsigned threads,
                  const std::function<void(Piece&)>& visit);

/** \brief Adds to \a wires the accepted pieces of free candidates along \a curves;
 * their points are claimed in \a growth. Finds what no straight neighborhood shows:
 * bundles, sparse and noisy wires, those in a wide beam. */
void
growAlong(const std::vector<Curve>& curves,
          Growth& growth,
          std::vector<Piece>& wires,
          const PowerLineSettings& settings);

} // namespace linelet::powerline
