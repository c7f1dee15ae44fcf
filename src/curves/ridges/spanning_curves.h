// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>

#include "ridge_trace.h"

namespace linelet {

/** \brief Curves along the minimum spanning tree of \a points: initial curves that need
 * no scale, for clouds too sparse or too unevenly spaced to trace ridges.
 *
 * The tree uses only edges to the 8 nearest neighbors; what these do not connect stays
 * separate. Its longest path is a curve, and so is each longest path that leaves a
 * curve, if it has at least \a least_edges edges; shorter ones are noise. */
Traces
spanningCurves(const Points& points, std::size_t least_edges);

} // namespace linelet
