// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>

#include <linelet/powerline/power_line_network.h>

namespace linelet::powerline {

namespace {

constexpr double degree = M_PI / 180;

Point
forward(double azimuth)
{
  return {std::sin(azimuth * degree), std::cos(azimuth * degree), 0};
}

Point
upward(double azimuth, double swing)
{
  const Point right(std::cos(azimuth * degree), -std::sin(azimuth * degree), 0);
  return std::cos(swing * degree) * Point::UnitZ() + std::sin(swing * degree) * right;
}

} // namespace

Point
Catenary::at(double s) const
{
  // cosh(x) - 1 = 2 sinh(x / 2)^2 keeps its digits for small x.
  const double half = std::sinh(s / (2 * a));
  return lowest + s * forward(azimuth) + 2 * a * half * half * upward(azimuth, swing);
}

double
Catenary::along(const Point& p) const
{
  return forward(azimuth).dot(p - lowest);
}

double
Catenary::distance(const Point& p) const
{
  const double s = along(p);
  const Point offset = p - at(s);
  const Point right = upward(azimuth, 90);
  const double slope = std::sinh(s / a) * std::cos(swing * degree);
  return std::hypot(right.dot(offset), offset.z() / std::sqrt(1 + slope * slope));
}

Points
Catenary::polyline(double deviation) const
{
  // A chord of length c stays within c^2 / 8a of a curve whose bend is at most 1 / a.
  const double step = std::sqrt(8 * std::max(1e-6, deviation) * a);
  const double pieces = std::clamp(std::ceil((to - from) / step), 1.0, 1e5);
  Points vertices;
  for (int k = 0; k <= static_cast<int>(pieces); ++k)
    vertices.push_back(at(from + (to - from) * k / pieces));
  return vertices;
}

Points
polyline(const Wire& wire, double deviation)
{
  Points vertices = wire.curve.polyline(deviation);
  vertices.front() = wire.front;
  vertices.back() = wire.back;
  return vertices;
}

} // namespace linelet::powerline
