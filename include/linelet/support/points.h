// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include <linelet/support/visibility.h>

namespace LINELET_PUBLIC linelet {

/** \brief A point or vector in space, in the unit of the input (meters for LiDAR).
 *
 * In double, and close to the origin (see io::Cloud::shift) so that a float copy in a
 * PCL cloud loses nothing that matters. */
using Point = Eigen::Vector3d;

/** \brief Points in input order, which defines their indices everywhere. */
using Points = std::vector<Point>;

/** \brief Index of a point in its cloud. */
using Index = std::uint32_t;

/** \brief Indices of points, in the order that the returning function states. */
using Indices = std::vector<Index>;

} // namespace linelet
