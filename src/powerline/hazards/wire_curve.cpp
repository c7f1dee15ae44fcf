// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/hazards/wire_curve.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace linelet::powerline {

namespace {

constexpr int newton_steps = 5; // curves are so flat that three would do

} // namespace

WireCurve::WireCurve(const Catenary& curve)
    : lowest_(curve.lowest), a_(curve.a), from_(curve.from), to_(curve.to)
{
  Catenary unit = curve; // its axes, from differences along it
  unit.lowest = Point::Zero();
  unit.swing = 0;
  forward_ = unit.at(1) - unit.at(-1);
  forward_ = Point(forward_.x(), forward_.y(), 0).normalized();
  const Point right(forward_.y(), -forward_.x(), 0);
  const double swing = curve.swing * M_PI / 180;
  up_ = std::cos(swing) * Point::UnitZ() + std::sin(swing) * right;
  across_ = forward_.cross(up_);
}

Point
WireCurve::at(double s) const
{
  const double half = std::sinh(s / (2 * a_));
  return lowest_ + s * forward_ + 2 * a_ * half * half * up_;
}

double
WireCurve::nearestAlong(double x, double y) const
{
  double s = std::clamp(x, from_, to_);
  for (int k = 0; k < newton_steps; ++k) {
    const double half = std::sinh(s / (2 * a_));
    const double height = 2 * a_ * half * half, slope = std::sinh(s / a_);
    const double first = s - x + (height - y) * slope;
    const double second =
        1 + slope * slope +
        (height - y) * std::cosh(s / a_) / a_; // > 0 if y < height + a
    s = std::clamp(s - first / std::max(second, 0.1), from_, to_);
  }
  return s;
}

double
WireCurve::nearest(const Point& p) const
{
  const Point d = p - lowest_;
  return nearestAlong(forward_.dot(d), up_.dot(d));
}

std::pair<double, double>
WireCurve::within(const Point& p, double radius) const
{
  const Point d = p - lowest_;
  const double x = forward_.dot(d), y = up_.dot(d), z = across_.dot(d);
  const double limit = radius * radius;
  // Most points are farther to the side of the wire, or farther below its lowest point.
  if (z * z > limit || (y < 0 && y * y > limit))
    return {1, 0};
  const double middle = nearestAlong(x, y);
  const auto squared = [&](double s) {
    const double half = std::sinh(s / (2 * a_));
    const double dx = s - x, dy = 2 * a_ * half * half - y;
    return dx * dx + dy * dy + z * z;
  };
  const double least = squared(middle);
  if (!(least <= limit))
    return {1, 0};
  // The squared distance rises on both sides, so Newton's method starts outside.
  const auto end = [&](double sign) {
    double s = middle + sign * std::sqrt(limit - least);
    for (int k = 0; k < newton_steps; ++k) {
      const double half = std::sinh(s / (2 * a_));
      const double rise =
          2 * (s - x) + 2 * (2 * a_ * half * half - y) * std::sinh(s / a_);
      if (sign * rise <= 0)
        break;
      s -= (squared(s) - limit) / rise;
    }
    return sign > 0 ? std::min(s, to_) : std::max(s, from_);
  };
  return {std::min(end(-1), middle), std::max(end(1), middle)};
}

std::vector<WireCurve>
curvesOf(const std::vector<Wire>& wires)
{
  std::vector<WireCurve> curves;
  curves.reserve(wires.size());
  for (const Wire& wire : wires)
    curves.emplace_back(wire.curve);
  return curves;
}

} // namespace linelet::powerline
