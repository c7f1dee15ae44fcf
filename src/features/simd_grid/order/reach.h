// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>
#include <limits>

#include <linelet/features/cloud_piece.h>
#include <linelet/support/points.h>

namespace linelet::grid {

/** \brief Box of the finite ones of a set of points. */
struct Bounds {
  Point low = Point::Constant(std::numeric_limits<double>::infinity());
  Point high = -low;

  explicit Bounds(const Points& points) { add(points); }

  /** \brief Of the whole cloud, where the points are a piece of one. */
  Bounds(const Points& points, const CloudPiece* piece)
  {
    if (piece == nullptr)
      add(points);
    else {
      low = piece->low;
      high = piece->high;
    }
  }

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

/** \brief The smallest power of two above \a length. */
inline double
powerAbove(double length)
{
  return std::ldexp(1, std::ilogb(length) + 1);
}

/** \brief A length larger than any distance between points in \a bounds, by enough that
 * rounding does not matter. */
inline double
reachOf(const Bounds& bounds)
{
  const double diagonal = bounds.empty() ? 0 : (bounds.high - bounds.low).norm();
  return diagonal > 0 ? powerAbove(2 * diagonal)
                      : std::numeric_limits<double>::infinity();
}

} // namespace linelet::grid
