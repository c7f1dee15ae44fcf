// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <vector>

#include <linelet/support/points.h>
#include <linelet/tensor/neighborhood_tensor.h>

#include "point_passes.h"

namespace linelet::clustering {

/** \brief How far the borders move under MoveRule::Population: for every slot and face,
 * the number of steps from it that belong to the cell beyond.
 * \param[in] border_counts see PointPasses::borderCounts
 * \param[in] populations of every slot
 * \param[in] passes how often */
std::vector<std::uint8_t>
populationShifts(const std::vector<std::uint32_t>& border_counts,
                 std::vector<std::int64_t> populations,
                 const Indices& neighbors,
                 unsigned passes);

/** \brief Mean and covariance from sums. */
struct CellMoments {
  Point mean = Point::Zero();
  SymmetricTensor tensor;
};

CellMoments
momentsOf(const CellSums& sums, const CellOrigin& origin);

/** \brief The plane through the members of a cell: at least three, not on a line. */
CellPlane
planeOf(const CellSums& sums, const CellOrigin& origin);

} // namespace linelet::clustering
