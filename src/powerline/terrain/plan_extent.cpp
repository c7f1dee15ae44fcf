// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/terrain/plan_extent.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace linelet::powerline {

namespace {

constexpr double beyond = 3; // in sizes of the middle half of the points

// The rectangle without points far from the middle half of all points.
PlanExtent
withoutStrays(PlanExtent extent, const Points& points)
{
  std::vector<double> values;
  for (int axis = 0; axis < 2; ++axis) {
    values.clear();
    for (const Point& p : points)
      if (p.allFinite())
        values.push_back(p[axis]);
    const auto quantile = [&](double part) {
      const auto place =
          values.begin() +
          static_cast<std::ptrdiff_t>(part * static_cast<double>(values.size() - 1));
      std::nth_element(values.begin(), place, values.end());
      return *place;
    };
    const double first = quantile(0.25), last = quantile(0.75);
    const double reach = beyond * (last - first);
    extent.low[axis] = std::max(extent.low[axis], first - reach);
    extent.high[axis] = std::min(extent.high[axis], last + reach);
  }
  return extent;
}

} // namespace

PlanExtent
planExtent(const Points& points, double cell)
{
  PlanExtent extent;
  extent.low.setConstant(std::numeric_limits<double>::infinity());
  extent.high = -extent.low;
  for (const Point& p : points)
    if (p.allFinite()) {
      extent.low = extent.low.cwiseMin(p.head<2>());
      extent.high = extent.high.cwiseMax(p.head<2>());
      ++extent.points;
    }
  if (extent.points == 0)
    return {};
  const double most = 4.0 * static_cast<double>(extent.points) + 1e6;
  return extent.cells(cell) > most ? withoutStrays(extent, points) : extent;
}

} // namespace linelet::powerline
