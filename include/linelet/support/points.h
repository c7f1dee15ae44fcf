// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace linelet {

/** \brief A point or vector in space, in the unit of the input (meters for LiDAR).
 *
 * Double precision: what is stored here is close to the origin (see io::Cloud::shift),
 * so that its float copy in a PCL cloud loses nothing that matters. */
using Point = Eigen::Vector3d;

/** \brief Points in input order; a point's place in it is its index everywhere. */
using Points = std::vector<Point>;

/** \brief Index of a point in its cloud. */
using Index = std::uint32_t;

/** \brief Indices of points, in the order stated by whoever returns them. */
using Indices = std::vector<Index>;

} // namespace linelet
