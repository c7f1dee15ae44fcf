// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <linelet/powerline/power_line_settings.h>
#include <linelet/support/progress_monitor.h>

#include "powerline/pieces/candidates.h"
#include "powerline/pieces/growth.h"

namespace linelet::powerline {

/** \brief Turns \a piece into a bundle of unresolved conductors, if it is a dense one,
 * so that its conductors do not count as surroundings. */
bool
becomesBundle(const Growth& growth, Piece& piece, const PowerLineSettings& settings);

/** \brief All accepted wires that grow from \a seeds, their points claimed in \a growth
 * (owner: index in the result). */
std::vector<Piece>
growAll(Growth& growth,
        const std::vector<Seed>& seeds,
        const PowerLineSettings& settings,
        ProgressMonitor* monitor);

/** \brief Adds to \a pieces the remnants of narrow bundles, and of wires that
 * misaligned strips show twice: their conductors are too close together to be found one
 * by one. */
void
addBundles(Growth& growth,
           const std::vector<Seed>& seeds,
           std::vector<Piece>& pieces,
           const PowerLineSettings& settings);

} // namespace linelet::powerline
