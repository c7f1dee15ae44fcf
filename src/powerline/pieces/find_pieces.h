// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <linelet/powerline/power_line_settings.h>
#include <linelet/support/progress_monitor.h>

#include "powerline/pieces/candidates.h"
#include "powerline/pieces/growth.h"

namespace linelet::powerline {

/** \brief Makes \a piece a bundle whose conductors the points do not tell apart, if it
 * is one and dense: its conductors then are no company. */
bool
becomesBundle(const Growth& growth, Piece& piece, const PowerLineSettings& settings);

/** \brief All accepted wires that grow from \a seeds, their points claimed in \a growth
 * (owner: place in the result). */
std::vector<Piece>
growAll(Growth& growth,
        const std::vector<Seed>& seeds,
        const PowerLineSettings& settings,
        ProgressMonitor* monitor);

/** \brief Adds to \a pieces what is left of thin bundles, or of wires that strips which
 * do not fit show twice: their conductors are too near each other to be found one by
 * one. */
void
addBundles(Growth& growth,
           const std::vector<Seed>& seeds,
           std::vector<Piece>& pieces,
           const PowerLineSettings& settings);

} // namespace linelet::powerline
