// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <linelet/features/multi_scale.h>

namespace linelet {

/** \brief The shapes of all queries at the radii of \a result, one pass of the grid
 * engine a radius. Nothing is shared between the passes, but a vector sweep is so much
 * faster that from a few hundred neighbours a point on all of them together beat one
 * shared search in double, and for medians come close to it (`linelet-benchmark
 * --benchmark_filter=multiscale-cost`).
 * \param[in,out] result shapes are filled in */
void
multiScaleShapesOnGrid(const Points& surface,
                       const Points& queries,
                       const MultiScaleSettings& settings,
                       const ShapeGraphSink& sink,
                       Monitor* monitor,
                       MultiScaleShapes& result);

} // namespace linelet
