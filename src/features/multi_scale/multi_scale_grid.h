// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <vector>

#include <linelet/features/cloud_piece.h>
#include <linelet/features/fourth_order.h>
#include <linelet/features/multi_scale_settings.h>
#include <linelet/features/multi_scale_types.h>

namespace linelet {

/** \brief No more threads than have something to do: for few queries, waking a thread
 * costs more than it saves. */
int
usefulThreads(unsigned requested, std::size_t queries);

/** \brief The shapes of all queries at the radii of \a result, by one sweep of the grid
 * engine over all scales.
 * \param[in] piece whose shapes are wanted, then queries are the surface; null: all
 * \param[in,out] result shapes are filled in
 * \return false, and nothing done, if the points cannot be sorted into blocks because
 * the radius is too small for their extent */
bool
multiScaleShapesOnGrid(const Points& surface,
                       const Points& queries,
                       const CloudPiece* piece,
                       const MultiScaleSettings& settings,
                       const ShapeGraphSink& sink,
                       ProgressMonitor* monitor,
                       MultiScaleShapes& result);

/** \brief Fourth-order tensors of all queries, by the same sweep.
 * \param[in,out] tensors one per query
 * \return as \ref multiScaleShapesOnGrid */
bool
fourthOrderTensorsOnGrid(const Points& surface,
                         const Points& queries,
                         const std::vector<double>& radii,
                         const MultiScaleSettings& settings,
                         ScaleWeight weight,
                         ProgressMonitor* monitor,
                         std::vector<FourthOrderTensor>& tensors);

} // namespace linelet
