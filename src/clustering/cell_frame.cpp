// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "cell_frame.h"

#include <algorithm>

namespace linelet::clustering {

Point
CellFrame::inView(double across, double down, double depth) const
{
  return eye + axes.transpose() * Point((across / scale_x - tangent_x) * depth,
                                        (down / scale_y - tangent_y) * depth,
                                        depth);
}

Point
CellFrame::middle(const Cell& cell) const
{
  const Point at(cell[0] + 0.5, cell[1] + 0.5, cell[2] + 0.5);
  if (!perspective)
    return low + at.cwiseProduct(size);
  const auto layer = static_cast<std::size_t>(cell[2]);
  return inView(at.x(), at.y(), (depths[layer] + depths[layer + 1]) / 2);
}

Point
CellFrame::corner(const Cell& cell) const
{
  if (!perspective)
    return low + Point(cell[0], cell[1], cell[2]).cwiseProduct(size);
  return inView(cell[0], cell[1], depths[static_cast<std::size_t>(cell[2])]);
}

Point
CellFrame::reach(const Cell& cell) const
{
  if (!perspective)
    return size;
  // Along the view up to the far end of the neighbor behind, across it a cell and a
  // half at that depth. The corners of a cell can point along any axis of space.
  const auto layer = static_cast<std::size_t>(cell[2]);
  const double front = depths[layer > 0 ? layer - 1 : 0];
  const double back = depths[std::min(layer + 2, depths.size() - 1)];
  const Point half_way(
      (tangent_x + 1.5 / scale_x) * (back - front) + 1.5 * back / scale_x,
      (tangent_y + 1.5 / scale_y) * (back - front) + 1.5 * back / scale_y,
      back - front);
  return Point::Constant(half_way.norm() / 2);
}

} // namespace linelet::clustering
