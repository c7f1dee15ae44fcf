// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/fittings/curve_through.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace linelet::powerline {

namespace {

/** The foot of a point on a polyline. */
struct Foot {
  double along = 0; ///< from its first vertex
  double distance = std::numeric_limits<double>::infinity();
};

Foot
footOf(const Points& course, const Point& p)
{
  Foot best;
  double along = 0;
  if (course.size() == 1)
    best = {0, (p - course.front()).norm()};
  for (std::size_t v = 1; v < course.size(); ++v) {
    const Point edge = course[v] - course[v - 1];
    const double length = edge.norm();
    const double part =
        length > 0
            ? std::clamp((p - course[v - 1]).dot(edge) / (length * length), 0.0, 1.0)
            : 0.0;
    const double d = (p - course[v - 1] - part * edge).norm();
    if (d < best.distance)
      best = {along + part * length, d};
    along += length;
  }
  return best;
}

double
lengthOf(const Points& course)
{
  double length = 0;
  for (std::size_t v = 1; v < course.size(); ++v)
    length += (course[v] - course[v - 1]).norm();
  return length;
}

// The weighted least-squares line through points near a place along the course,
// evaluated there.
Point
middleAt(double place,
         const Points& points,
         const std::vector<double>& along,
         double window)
{
  double total = 0, first = 0, second = 0;
  Point sum = Point::Zero(), moment = Point::Zero();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double x = (along[i] - place) / window;
    const double w = std::exp(-x * x / 2);
    total += w;
    first += w * x;
    second += w * x * x;
    sum += w * points[i];
    moment += w * x * points[i];
  }
  const double spread = total * second - first * first;
  if (spread < 1e-3 * total * total)
    return sum / total;
  return (second * sum - first * moment) / spread;
}

} // namespace

Points
curveThrough(const Points& course, const Points& points, double window)
{
  constexpr int rounds = 3; // then the places along the course are those of the curve
  Points curve = course;
  std::vector<double> along(points.size());
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t i = 0; i < points.size(); ++i)
      along[i] = footOf(curve, points[i]).along;
    const double length = lengthOf(curve);
    const int steps = std::max(1, static_cast<int>(std::lround(length / window)));
    Points next;
    for (int k = 0; k <= steps; ++k)
      next.push_back(middleAt(length * k / steps, points, along, window));
    curve = std::move(next);
  }
  return curve;
}

double
distanceTo(const Points& course, const Point& p)
{
  return footOf(course, p).distance;
}

} // namespace linelet::powerline
