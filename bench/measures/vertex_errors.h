// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <bench/measures/segment_tree.h>
#include <linelet/curves/curve_network.h>

namespace linelet::bench {

/** \brief Error of a reconstructed curve at one of its vertices. */
struct VertexError {
  double along = 0;    ///< arc length
  double distance = 0; ///< from the nearest point of the truth; infinite without one
  double angle = 0;    ///< between tangents, degrees in [0, 90]; NaN without one
};

/** \brief The errors along \a curve, compared with \a truth. */
std::vector<VertexError>
vertexErrors(const Curve& curve, const SegmentTree& truth);

} // namespace linelet::bench
