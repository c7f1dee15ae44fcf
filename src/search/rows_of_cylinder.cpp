// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/search/rows_of_cylinder.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace linelet {

namespace {

using Interval = std::array<double, 2>;

constexpr Interval nowhere{1, 0};

/** \brief The part of \a range where \a low <= a t <= \a high. */
Interval
cut(const Interval& range, double a, double low, double high)
{
  if (a == 0)
    return low <= 0 && high >= 0 ? range : nowhere;
  double first = low / a, last = high / a;
  if (first > last)
    std::swap(first, last);
  return {std::max(range[0], first), std::min(range[1], last)};
}

double
distanceTo(const Interval& x)
{
  return std::max({0.0, x[0], -x[1]});
}

/** \brief All a x with x in \a range. */
Interval
times(double a, const Interval& x)
{
  if (a == 0)
    return {0, 0};
  const double first = a * x[0], second = a * x[1];
  return first < second ? Interval{first, second} : Interval{second, first};
}

} // namespace

RowsOfCylinder::RowsOfCylinder(const Point& from,
                               const Point& to,
                               double radius,
                               double margin)
    : middle_(0.5 * (from + to)), axis_(0.5 * (to - from)), radius_(radius + margin)
{
  axis_ += margin * axis_.normalized();
  half_ = axis_.squaredNorm();
  squared_reach_ = half_ + radius_ * radius_;
  for (int k = 0; k < 3; ++k) {
    const double share = half_ > 0 ? axis_[k] * axis_[k] / half_ : 0;
    const double extent =
        std::abs(axis_[k]) + radius_ * std::sqrt(std::max(0.0, 1 - share));
    low[k] = middle_[k] - extent;
    high[k] = middle_[k] + extent;
  }
}

std::array<double, 2>
RowsOfCylinder::alongRow(const Interval& y_of_row, const Interval& z_of_row) const
{
  // Relative to the middle, clipped to the box.
  const Interval y{std::max(y_of_row[0], low.y()) - middle_.y(),
                   std::min(y_of_row[1], high.y()) - middle_.y()};
  const Interval z{std::max(z_of_row[0], low.z()) - middle_.z(),
                   std::min(z_of_row[1], high.z()) - middle_.z()};
  if (!(y[0] <= y[1] && z[0] <= z[1]))
    return nowhere;
  // The ball around it.
  const double across_y = distanceTo(y), across_z = distanceTo(z);
  const double rest = squared_reach_ - across_y * across_y - across_z * across_z;
  if (rest < 0)
    return nowhere;
  const double ball = std::sqrt(rest);
  Interval x{std::max(-ball, low.x() - middle_.x()),
             std::min(ball, high.x() - middle_.x())};
  // Between its ends: |axis . v| <= half the squared length.
  const Interval by_y = times(axis_.y(), y), by_z = times(axis_.z(), z);
  const double least = by_y[0] + by_z[0], most = by_y[1] + by_z[1];
  x = cut(x, axis_.x(), -half_ - most, half_ - least);
  // Around the part of its axis that is near enough to the row.
  Interval t{-1, 1};
  t = cut(t, axis_.y(), y[0] - radius_, y[1] + radius_);
  t = cut(t, axis_.z(), z[0] - radius_, z[1] + radius_);
  if (!(t[0] <= t[1]))
    return nowhere;
  const Interval of_axis = times(axis_.x(), t);
  return {middle_.x() + std::max(x[0], of_axis[0] - radius_),
          middle_.x() + std::min(x[1], of_axis[1] + radius_)};
}

} // namespace linelet
