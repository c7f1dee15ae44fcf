// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "powerline/growth.h"

namespace linelet::powerline {

/** \brief A wire found, with the parallel strands of its bundle that are no wires of
 * their own. */
struct Strand {
  Piece piece;
  std::vector<Piece> companions; ///< short parts of other conductors of the bundle
};

/** \brief Joins pieces that are parts of one wire: a single parabola explains both as
 * well as two do, and the gap between them is no longer than the settings allow. Joined
 * wires are fitted and extended again. */
void
mergePieces(Growth& growth,
            std::vector<Piece>& pieces,
            const PowerLineSettings& settings);

/** \brief Looks for more wires of the same shape beside those found: in a thin scan two
 * conductors a few meters apart make no line around any of their points. */
void
addParallelWires(Growth& growth,
                 std::vector<Piece>& pieces,
                 const PowerLineSettings& settings);

/** \brief Sorts out bundles: a short piece close beside a long one is completed to a
 * wire of its own by the shape of the long one, or becomes its companion. */
std::vector<Strand>
sortBundles(Growth& growth,
            std::vector<Piece> pieces,
            const PowerLineSettings& settings);

/** \brief Mean distance of two wires where they run side by side, and how far they do.
 */
struct Parallel {
  double distance = 0; ///< meters; of interest only with overlap > 0
  double overlap = 0;  ///< meters
};

Parallel
compare(const SpanModel& a, const SpanModel& b);

} // namespace linelet::powerline
