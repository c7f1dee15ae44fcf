// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string_view>
#include <vector>

#include <linelet/features/cloud_piece.h>
#include <linelet/features/tensor_record.h>
#include <linelet/support/progress_monitor.h>
#include <linelet/support/visibility.h>

namespace LINELET_PUBLIC linelet {

/** \brief Engine::Grid for radii: \ref estimateTensors, vectorized.
 *
 * Points are sorted into blocks twice as wide as the radius, whose corners are
 * multiples of their width; the inner loops run over vectors of candidates, on the best
 * instruction set found at run time. A record depends only on the points in its block
 * and the blocks around it. Sums are in float relative to the query's surroundings and
 * in double beyond them; numbers of neighbors are exactly those of the other engines,
 * shape factors agree to 1e-4 (median and step: exactly). Besides input and output it
 * needs 30 to 40 bytes per point, plus some 20 bytes per candidate and thread, which
 * matters only if a ball holds a large part of the cloud.
 *
 * Settings and sizes are those of \ref estimateTensors with a radius, or one per query.
 * \throws std::invalid_argument, Canceled as there */
std::vector<PointDistributionTensor>
estimateTensorsOnGrid(const Points& surface,
                      const Points& queries,
                      const TensorSettings& settings,
                      const NeighborhoodSizes& sizes = {},
                      ProgressMonitor* monitor = nullptr);

/** \brief The same for the points of a piece; \a points also holds all those within
 * \ref gridMargin of it.
 * \param[in] sizes one for each of \a points, or none
 * \return one record for each point of the piece */
std::vector<PointDistributionTensor>
pieceTensorsOnGrid(const Points& points,
                   const CloudPiece& piece,
                   const TensorSettings& settings,
                   const NeighborhoodSizes& sizes = {},
                   ProgressMonitor* monitor = nullptr);

/** \brief How far around a piece its points must be known: two blocks of the largest
 * radius. */
double
gridMargin(const TensorSettings& settings, const NeighborhoodSizes& sizes = {});

/** \brief Name of the instruction set that the grid engine runs on here. */
std::string_view
gridInstructionSet();

} // namespace linelet
