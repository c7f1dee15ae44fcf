// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>

#include "ridge_trace.h"

namespace linelet {

/** \brief Curves along the shortest tree that spans \a points: a start that knows no
 * scale, for clouds so sparse or so unevenly spaced that no ridge can be traced.
 *
 * The tree joins each point to its neighbors first (of the 8 nearest; what these leave
 * apart stays apart). Its longest path is a curve, and so is the longest path that
 * leaves a curve, as long as it has \a least_edges edges; shorter ones are noise. */
Traces
spanningCurves(const Points& points, std::size_t least_edges);

} // namespace linelet
