// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>

#include <linelet/support/points.h>

namespace linelet::powerline {

/** \brief A rectangle in plan, for rasters. */
struct PlanExtent {
  Eigen::Vector2d low = Eigen::Vector2d::Zero(), high = Eigen::Vector2d::Zero();
  std::size_t points = 0; ///< finite ones, of the whole cloud

  bool
  contains(const Point& p) const
  {
    return (p.head<2>().array() >= low.array()).all() &&
           (p.head<2>().array() <= high.array()).all();
  }

  /** \brief Cells of a raster with that side. */
  double
  cells(double side) const
  {
    return ((high - low).array() / side + 1).floor().prod();
  }
};

/** \brief The corner of the cell that \a low is in, if the centers of cells are
 * multiples of \a side. Rasters begin there, so that they do not depend on where a
 * cloud was cut. */
inline Eigen::Vector2d
rasterCorner(const Eigen::Vector2d& low, double side)
{
  return side * ((low / side).array() + 0.5).floor() - side / 2;
}

/** \brief Where the points lie. If a raster of \a cell meters over all of them would
 * have far more cells than there are points, stray points far away are left out: those
 * farther from the middle half of the points than three times its size. */
PlanExtent
planExtent(const Points& points, double cell);

} // namespace linelet::powerline
