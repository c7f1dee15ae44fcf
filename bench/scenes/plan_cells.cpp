// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "plan_cells.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace linelet::bench {

PlanCells::PlanCells(const Point& low, const Point& high, double cell)
    : low_(low), cell_(cell)
{
  columns_ = static_cast<std::size_t>(std::max(0.0, (high.x() - low.x()) / cell)) + 1;
  rows_ = static_cast<std::size_t>(std::max(0.0, (high.y() - low.y()) / cell)) + 1;
  cells_.resize(columns_ * rows_);
}

std::size_t
PlanCells::cellOf(double x, double y) const
{
  const auto place = [this](double from, double at, std::size_t count) {
    const double index = std::floor((at - from) / cell_);
    return static_cast<std::size_t>(
        std::clamp(index, 0.0, static_cast<double>(count - 1)));
  };
  return place(low_.y(), y, rows_) * columns_ + place(low_.x(), x, columns_);
}

void
PlanCells::insert(std::uint32_t id, const Point& low, const Point& high)
{
  const std::size_t first = cellOf(low.x(), low.y()), last = cellOf(high.x(), high.y());
  for (std::size_t row = first / columns_; row <= last / columns_; ++row)
    for (std::size_t column = first % columns_; column <= last % columns_; ++column)
      cells_[row * columns_ + column].push_back(id);
}

std::optional<double>
meetTriangle(const Point& origin,
             const Point& direction,
             const Point& a,
             const Point& b,
             const Point& c)
{
  const Point e1 = b - a, e2 = c - a;
  const Point p = direction.cross(e2);
  const double det = e1.dot(p);
  if (std::abs(det) < 1e-9)
    return std::nullopt;
  const Point s = origin - a;
  const double u = s.dot(p) / det;
  const Point q = s.cross(e1);
  const double v = direction.dot(q) / det;
  if (u < 0 || v < 0 || u + v > 1)
    return std::nullopt;
  return e2.dot(q) / det;
}

} // namespace linelet::bench
