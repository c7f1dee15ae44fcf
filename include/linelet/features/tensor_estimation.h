// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <linelet/features/cloud_piece.h>
#include <linelet/features/tensor_record.h>
#include <linelet/features/tensor_search.h>
#include <linelet/support/visibility.h>

namespace LINELET_PUBLIC linelet {

/** \brief The neighborhood tensor of every query point (Ritter et al. 2012).
 * \param[in] surface the points among which neighbors are sought
 * \param[in] queries centers of the neighborhoods; a query that is not finite gets NaN
 * \param[in] settings with a radius or k, or neither if \a sizes gives them per point
 * \return one record per query, in order
 * \throws std::invalid_argument see \ref validate
 * \throws Canceled */
std::vector<PointDistributionTensor>
estimateTensors(const Points& surface,
                const Points& queries,
                const TensorSettings& settings,
                const NeighborhoodSizes& sizes = {},
                ProgressMonitor* monitor = nullptr);

/** \brief The same for the points of a piece of a cloud.
 * \param[in] points the piece, and all those within \ref tensorMargin of it
 * \param[in] settings with the engine that the whole cloud would use
 * \param[in] sizes one for each of \a points, or none
 * \return one record for each point of the piece, in order */
std::vector<PointDistributionTensor>
pieceTensors(const Points& points,
             const CloudPiece& piece,
             const TensorSettings& settings,
             const NeighborhoodSizes& sizes = {},
             ProgressMonitor* monitor = nullptr);

/** \brief How far around a piece the points must be known, for neighborhoods by radius;
 * those of k nearest points reach as far as the k-th. */
double
tensorMargin(const TensorSettings& settings, const NeighborhoodSizes& sizes = {});

} // namespace linelet
