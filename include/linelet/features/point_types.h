// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>

#include <linelet/support/visibility.h>

namespace LINELET_PUBLIC linelet {

/** \brief The neighborhood tensor of a point and quantities derived from it.
 *
 * All floats are NaN if the tensor is undefined: for a query that is not finite, no
 * neighbors, all neighbors at the point of reference, or all weights 0. \ref neighbors
 * is always the number found. */
struct PointDistributionTensor {
  float xx, xy, xz, yy, yz, zz;           ///< the tensor, squared length
  float lambda1, lambda2, lambda3;        ///< its eigenvalues, ascending
  float major_x, major_y, major_z;        ///< e3: unit vector along the largest extent
  float normal_x, normal_y, normal_z;     ///< e1: unit vector along the smallest extent
  float linearity, planarity, sphericity; ///< shape factors in [0, 1], sum 1
  std::uint32_t neighbors; ///< points in the neighborhood, the query point included
                           ///< where it belongs to the search surface
};

} // namespace linelet
