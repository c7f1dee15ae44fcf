// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/tensor/centroid.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace linelet {

namespace {

Point
mean(const Points& points)
{
  const double count = static_cast<double>(points.size());
  Point sum = Point::Zero();
  for (const Point& point : points)
    sum += point;
  const Point rough = sum / count;
  // The rest that rounding left, so that coincident points have their own place as
  // mean.
  sum.setZero();
  for (const Point& point : points)
    sum += point - rough;
  return rough + sum / count;
}

Point
weightedMean(const Points& points,
             const Point& query,
             double inverse_radius,
             const Weighting& weighting)
{
  Point sum = Point::Zero();
  double total = 0;
  for (const Point& point : points) {
    const Point offset = point - query;
    const double weight = weighting(offset.norm() * inverse_radius);
    sum += weight * offset;
    total += weight;
  }
  if (!(total > 0))
    return mean(points);
  return query + sum / total;
}

/** \brief The terms of one step of Weiszfeld's iteration at a place x. */
struct Pull {
  Point resultant = Point::Zero(); ///< sum of w_i u_i, u_i unit vectors to neighbours
  double stiffness = 0;            ///< sum of w_i / d_i
  double here = 0;                 ///< weight of the neighbours that lie at x
  double nearest = std::numeric_limits<double>::infinity(); ///< distance, other than 0
  std::size_t nearest_index = 0;
};

Pull
pullAt(const Point& x,
       const Points& points,
       double inverse_radius,
       const Weighting* weighting)
{
  Pull pull;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point offset = points[i] - x;
    const double distance = offset.norm();
    const double weight =
        weighting == nullptr ? 1.0 : (*weighting)(distance * inverse_radius);
    if (distance == 0) {
      pull.here += weight;
      continue;
    }
    if (distance < pull.nearest) {
      pull.nearest = distance;
      pull.nearest_index = i;
    }
    const double stiffness = weight / distance;
    pull.resultant += stiffness * offset;
    pull.stiffness += stiffness;
  }
  return pull;
}

Point
median(const Points& points, double inverse_radius, const Weighting* weighting)
{
  Point x = mean(points);
  double size = 0;
  for (const Point& point : points)
    size = std::max(size, (point - x).norm());
  if (size == 0)
    return x;

  // Steps shrink by a constant factor a turn, so the last one bounds what is missing.
  constexpr int most_iterations = 1000;
  const double precise_enough = 1e-10 * size, close = 1e-3 * size;
  std::size_t tried = points.size();
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    const Pull pull = pullAt(x, points, inverse_radius, weighting);
    const double resultant = pull.resultant.norm();
    // A neighbour is the median if it outweighs the pull of all others (Vardi, Zhang).
    if (!(pull.stiffness > 0) || resultant <= pull.here)
      return x;
    // Convergence towards a neighbour is slow; ask whether it is the median instead.
    if (pull.nearest < close && pull.nearest_index != tried) {
      tried = pull.nearest_index;
      const Pull there = pullAt(points[tried], points, inverse_radius, weighting);
      if (there.resultant.norm() <= there.here)
        return points[tried];
    }
    const Point step = (1 - pull.here / resultant) / pull.stiffness * pull.resultant;
    x += step;
    if (step.norm() <= precise_enough)
      break;
  }
  return x;
}

} // namespace

Point
centroid(Centroid type,
         const Points& neighbours,
         const Point& query,
         double radius,
         const Weighting& weighting)
{
  if (neighbours.empty())
    return Point::Constant(std::numeric_limits<double>::quiet_NaN());
  const double inverse_radius = radius > 0 ? 1 / radius : 0;
  switch (type) {
  case Centroid::Mean:
    return mean(neighbours);
  case Centroid::WeightedMean:
    return weightedMean(neighbours, query, inverse_radius, weighting);
  case Centroid::Median:
    return median(neighbours, inverse_radius, nullptr);
  case Centroid::WeightedMedian:
    return median(neighbours, inverse_radius, &weighting);
  case Centroid::QueryPoint:
    break;
  }
  return query;
}

} // namespace linelet
