// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

#include <linelet/support/points.h>

#include "point_passes.h"

namespace linelet::clustering {

/** \brief Adds integer offsets from the middle of a cell to its sums or, with \a Sign
 * -1, subtracts them. */
template <int Sign>
void
addOffsets(std::int64_t x, std::int64_t y, std::int64_t z, CellSums& sum)
{
  sum.count += Sign;
  sum.first[0] += Sign * x;
  sum.first[1] += Sign * y;
  sum.first[2] += Sign * z;
  sum.second[0] += Sign * (x * x);
  sum.second[1] += Sign * (x * y);
  sum.second[2] += Sign * (x * z);
  sum.second[3] += Sign * (y * y);
  sum.second[4] += Sign * (y * z);
  sum.second[5] += Sign * (z * z);
}

/** \brief Adds \a p to the sums of the cell of \a origin, or subtracts it. */
template <int Sign>
void
addPoint(const Point& p, const CellOrigin& origin, CellSums& sum)
{
  const auto offset = [&](std::size_t a) {
    const double at = p[static_cast<Eigen::Index>(a)] - origin.middle[a];
    return static_cast<std::int64_t>(std::lrint(at * origin.scale[a]));
  };
  const std::int64_t x = offset(0), y = offset(1), z = offset(2);
  addOffsets<Sign>(x, y, z, sum);
}

/** \brief Distance of \a p from \a plane; NaN, for which every comparison is false, if
 * there is no plane. */
inline double
distance(const CellPlane& plane, const Point& p)
{
  const double x = (p.x() - plane.point[0]) * plane.normal[0];
  const double y = (p.y() - plane.point[1]) * plane.normal[1];
  const double z = (p.z() - plane.point[2]) * plane.normal[2];
  return std::abs((x + y) + z);
}

} // namespace linelet::clustering
