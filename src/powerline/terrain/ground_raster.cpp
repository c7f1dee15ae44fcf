// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/terrain/ground_raster.h"

#include <limits>

namespace linelet::powerline {

Ground
emptyGround(const PlanExtent& extent)
{
  Ground g;
  if (extent.points == 0)
    return g;
  const double most = 4.0 * static_cast<double>(extent.points) + 1e6;
  for (g.cell = ground_cell_size; extent.cells(g.cell) > most; g.cell *= 2) {
  }
  const Eigen::Vector2d corner = rasterCorner(extent.low, g.cell);
  const Eigen::Vector2d size = extent.high - corner;
  g.columns = static_cast<int>(size.x() / g.cell) + 1;
  g.rows = static_cast<int>(size.y() / g.cell) + 1;
  g.x = corner.x() + g.cell / 2;
  g.y = corner.y() + g.cell / 2;
  g.heights.assign(static_cast<std::size_t>(g.columns) *
                       static_cast<std::size_t>(g.rows),
                   std::numeric_limits<float>::quiet_NaN());
  return g;
}

} // namespace linelet::powerline
