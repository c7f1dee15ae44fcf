// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>

#include <linelet/features/point_types.h>
#include <linelet/features/tensor_settings.h>
#include <linelet/support/points.h>
#include <linelet/support/visibility.h>
#include <linelet/tensor/neighborhood_tensor.h>

namespace LINELET_PUBLIC linelet {

/** \brief The record of one neighborhood: centroid, tensor, eigen-analysis and shape
 * factors, all in double. Every engine uses it or is tested against it.
 * \param[in] offsets neighbors relative to the query point
 * \param[in] radius of the neighborhood, 0 if all neighbors lie at the query point
 */
PointDistributionTensor
tensorOf(const Points& offsets, double radius, const TensorSettings& settings);

/** \brief The record of a tensor: eigen-analysis and shape factors.
 * \param[in] tensor of the neighborhood
 * \param[in] extent distance of the farthest neighbor, see \ref shapeFactors
 * \param[in] neighbors number of neighbors */
PointDistributionTensor
recordOf(const SymmetricTensor& tensor, double extent, std::uint32_t neighbors);

/** \brief The record of a point whose tensor is undefined, with the number of neighbors
 * found. */
PointDistributionTensor
unknownTensor(std::uint32_t neighbors);

} // namespace linelet
