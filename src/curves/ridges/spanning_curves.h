// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>

#include "ridge_trace.h"

namespace linelet {

/** \brief Curves along the minimum spanning tree of \a points: a start that needs no
 * scale, for clouds so sparse or so unevenly spaced that no ridge can be traced.
 *
 * The tree uses edges to the 8 nearest neighbors only; what these do not connect stays
 * separate. Its longest path is a curve, and so is the longest path that leaves a
 * curve, as long as it has \a least_edges edges; shorter ones are noise. */
Traces
spanningCurves(const Points& points, std::size_t least_edges);

} // namespace linelet
