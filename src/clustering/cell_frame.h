// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <linelet/support/points.h>

namespace linelet::clustering {

using Cell = std::array<std::int32_t, 3>;

/** \brief The undistorted grid: boxes in space, or pieces of a camera's view whose
 * depth grows with their distance, so that all have similar proportions. */
struct CellFrame {
  Cell cells = {1, 1, 1}; ///< along each axis
  bool perspective = false;
  // Boxes
  Point low = Point::Zero();  ///< corner of the grid
  Point size = Point::Ones(); ///< of a cell
  Point inverse = Point::Ones();
  // Pieces of a view
  Point eye = Point::Zero();
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  double tangent_x = 1, tangent_y = 1; ///< half of the view at depth 1
  double scale_x = 1, scale_y = 1;     ///< cells per unit at depth 1
  std::vector<double> depths;          ///< where the layers of cells end, ascending

  /** \brief Finds the cell of \a point, and how far through it the point is, in [0, 1]
   * along each axis; in the middle if there is only one cell. Devices do the same: only
   * sums, products and quotients in double, in this order.
   * \return false if the point is not finite or not in view */
  template <bool Perspective>
  bool
  locate(const Point& point, Cell& cell, Point& part) const;

  /** \brief The middle of a cell. */
  Point
  middle(const Cell& cell) const;

  /** \brief The lower corner of a cell, which may be one past the last. */
  Point
  corner(const Cell& cell) const;

  /** \brief Half of the largest distance of a member, which may come from a neighbor,
   * from the middle of its cell, along each axis of space. */
  Point
  reach(const Cell& cell) const;

private:
  /** \brief The position in a camera's view at the given number of cells across and
   * down, and at the given depth. */
  Point
  inView(double across, double down, double depth) const;
};

template <>
inline bool
CellFrame::locate<false>(const Point& point, Cell& cell, Point& part) const
{
  for (std::size_t a = 0; a < 3; ++a) {
    const auto axis = static_cast<Eigen::Index>(a);
    const double at = (point[axis] - low[axis]) * inverse[axis];
    if (!(at >= 0 && at < 1e9))
      return false;
    cell[a] = std::min(static_cast<std::int32_t>(at), cells[a] - 1);
    part[axis] = cells[a] > 1 ? at - cell[a] : 0.5;
  }
  return true;
}

template <>
inline bool
CellFrame::locate<true>(const Point& point, Cell& cell, Point& part) const
{
  const double x = point.x() - eye.x(), y = point.y() - eye.y(),
               z = point.z() - eye.z();
  const double right = axes(0, 0) * x + axes(0, 1) * y + axes(0, 2) * z;
  const double down = axes(1, 0) * x + axes(1, 1) * y + axes(1, 2) * z;
  const double depth = axes(2, 0) * x + axes(2, 1) * y + axes(2, 2) * z;
  if (!(depth >= depths.front() && depth <= depths.back()))
    return false;
  const double across = (right / depth + tangent_x) * scale_x;
  const double along = (down / depth + tangent_y) * scale_y;
  if (!(across >= 0 && across <= cells[0] && along >= 0 && along <= cells[1]))
    return false;
  const auto end = std::upper_bound(depths.begin() + 1, depths.end() - 1, depth);
  cell[0] = std::min(static_cast<std::int32_t>(across), cells[0] - 1);
  cell[1] = std::min(static_cast<std::int32_t>(along), cells[1] - 1);
  cell[2] = static_cast<std::int32_t>(end - depths.begin()) - 1;
  part = {cells[0] > 1 ? across - cell[0] : 0.5,
          cells[1] > 1 ? along - cell[1] : 0.5,
          cells[2] > 1 ? (depth - end[-1]) / (end[0] - end[-1]) : 0.5};
  return true;
}

} // namespace linelet::clustering
