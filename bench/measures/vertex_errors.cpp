// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <bench/measures/vertex_errors.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

namespace linelet::bench {

namespace {

/** \brief Angle between two lines, degrees; NaN if one has no direction. */
double
angleBetween(const Point& a, const Point& b)
{
  if (!(a.norm() > 0) || !(b.norm() > 0))
    return std::numeric_limits<double>::quiet_NaN();
  constexpr double degrees = 180 / M_PI;
  return std::atan2(a.cross(b).norm(), std::abs(a.dot(b))) * degrees;
}

} // namespace

std::vector<VertexError>
vertexErrors(const Curve& curve, const SegmentTree& truth)
{
  std::vector<VertexError> errors;
  const std::size_t n = curve.points.size();
  double along = 0;
  std::size_t hint = SegmentTree::none;
  for (std::size_t i = 0; i < n; ++i) {
    const Point& vertex = curve.points[i];
    along += i > 0 ? (vertex - curve.points[i - 1]).norm() : 0;
    const SegmentTree::Nearest best = truth.nearest(vertex, hint);
    hint = best.segment;
    Point tangent = Point::Zero();
    if (hint != SegmentTree::none)
      tangent = truth.segments()[hint].b - truth.segments()[hint].a;
    const Point own =
        curve.points[std::min(i + 1, n - 1)] - curve.points[i > 0 ? i - 1 : 0];
    errors.push_back(
        {along, std::sqrt(best.squared_distance), angleBetween(own, tangent)});
  }
  return errors;
}

} // namespace linelet::bench
