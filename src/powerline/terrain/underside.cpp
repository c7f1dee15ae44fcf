// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/terrain/underside.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "powerline/terrain/plan_extent.h"

namespace linelet::powerline {

Underside::Underside(const Points& points)
{
  const PlanExtent extent = planExtent(points, cell_);
  if (extent.points == 0)
    return;
  const double most = 4.0 * static_cast<double>(extent.points) + 1e6;
  while (extent.cells(cell_) > most)
    cell_ *= 2;
  const Eigen::Vector2d corner = rasterCorner(extent.low, cell_);
  x_ = corner.x();
  y_ = corner.y();
  columns_ = static_cast<std::ptrdiff_t>((extent.high.x() - x_) / cell_) + 1;
  rows_ = static_cast<std::ptrdiff_t>((extent.high.y() - y_) / cell_) + 1;
  lowest_.assign(static_cast<std::size_t>(columns_ * rows_),
                 std::numeric_limits<float>::quiet_NaN());
  for (const Point& p : points)
    if (p.allFinite() && extent.contains(p)) {
      const auto c = static_cast<std::ptrdiff_t>((p.x() - x_) / cell_);
      const auto r = static_cast<std::ptrdiff_t>((p.y() - y_) / cell_);
      float& lowest = lowest_[static_cast<std::size_t>(r * columns_ + c)];
      lowest = std::fmin(lowest, static_cast<float>(p.z()));
    }
}

float
Underside::lowestAt(double x, double y) const
{
  const double c = std::floor((x - x_) / cell_), r = std::floor((y - y_) / cell_);
  if (!(c >= 0 && r >= 0 && c < static_cast<double>(columns_) &&
        r < static_cast<double>(rows_)))
    return std::numeric_limits<float>::quiet_NaN();
  return lowest_[static_cast<std::size_t>(static_cast<std::ptrdiff_t>(r) * columns_ +
                                          static_cast<std::ptrdiff_t>(c))];
}

bool
Underside::emptyAround(double x, double y, double reach) const
{
  for (double dx = -reach; dx <= reach; dx += cell_)
    for (double dy = -reach; dy <= reach; dy += cell_)
      if (!std::isnan(lowestAt(x + dx, y + dy)))
        return false;
  return true;
}

} // namespace linelet::powerline
