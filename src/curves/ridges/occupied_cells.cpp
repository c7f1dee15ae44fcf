// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "occupied_cells.h"

#include <algorithm>
#include <array>
#include <utility>

namespace linelet {

OccupiedCells
occupiedCells(const Points& points, double side)
{
  std::vector<std::pair<std::array<double, 3>, Index>> order;
  order.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points[i].allFinite()) {
      const Point cell = (points[i] / side).array().floor();
      order.push_back({{cell.x(), cell.y(), cell.z()}, static_cast<Index>(i)});
    }
  std::sort(order.begin(), order.end());
  OccupiedCells cells;
  cells.indices.reserve(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    if (k == 0 || order[k].first != order[k - 1].first)
      cells.begin.push_back(k);
    cells.indices.push_back(order[k].second);
  }
  cells.begin.push_back(order.size());
  return cells;
}

} // namespace linelet
