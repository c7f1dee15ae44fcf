// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <limits>

#include <linelet/support/points.h>

namespace linelet::grid {

/** \brief Box of the finite ones of a set of points. */
struct Bounds {
  Point low = Point::Constant(std::numeric_limits<double>::infinity());
  Point high = -low;

  explicit Bounds(const Points& points) { add(points); }

  void
  add(const Points& points)
  {
    for (const Point& point : points)
      if (point.allFinite()) {
        low = low.cwiseMin(point);
        high = high.cwiseMax(point);
      }
  }

  bool
  empty() const
  {
    return !(low.x() <= high.x());
  }
};

/** \brief A length beyond any distance of two points, and by so much that no rounding
 * matters to points that lie within it. */
inline double
reachOf(const Points& surface, const Points& queries)
{
  Bounds bounds(surface);
  if (&surface != &queries)
    bounds.add(queries);
  const double diagonal = bounds.empty() ? 0 : (bounds.high - bounds.low).norm();
  return diagonal > 0 ? 2 * diagonal : std::numeric_limits<double>::infinity();
}

} // namespace linelet::grid
