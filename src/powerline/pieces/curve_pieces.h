// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <linelet/curves/curve_network.h>
#include <linelet/powerline/power_line_settings.h>
#include <linelet/support/progress_monitor.h>

#include "powerline/pieces/growth.h"

namespace linelet::powerline {

/** \brief Parts of \a curve that hang as one parabola each, fitted to the free
 * candidates along it.
 *
 * The width of the tube that holds them follows from the points themselves: half of
 * those that stand out from the surroundings lie within the median distance, and a
 * curve wider than a single wire is a bundle. The curve is cut where two parabolas
 * explain its points better than one does (Bayesian information criterion). */
std::vector<Piece>
piecesAlong(const Curve& curve, const Growth& growth);

/** \brief Adds to \a wires the accepted pieces along curves of the free candidates;
 * their points are claimed in \a growth. Finds what no straight neighborhood shows:
 * bundles, sparse and noisy wires.
 * \return the curves, the longest first */
std::vector<Curve>
growAlongCurves(Growth& growth,
                std::vector<Piece>& wires,
                const PowerLineSettings& settings,
                ProgressMonitor* monitor);

} // namespace linelet::powerline
