// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/tensor/centroid.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <Eigen/Cholesky>

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

/** \brief Weights and coordinates of the sum of distances that a step lets fall. */
struct Distances {
  const Points& points;
  std::vector<double> weights;

  double
  sumFrom(const Point& x) const
  {
    double sum = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
      sum += weights[i] * (points[i] - x).norm();
    return sum;
  }
};

/** \brief What the points do to a place x: terms of the steps of Weiszfeld and Newton.
 */
struct Pull {
  Point resultant = Point::Zero(); ///< sum of w_i u_i, u_i unit vectors to neighbours
  double stiffness = 0;            ///< sum of w_i / d_i
  Eigen::Matrix3d curvature = Eigen::Matrix3d::Zero(); ///< sum of w_i/d_i (1 - u (x) u)
  double total = 0;                                    ///< sum of w_i
  double sum = 0;                                      ///< sum of w_i d_i
  double here = 0; ///< weight of the neighbours that lie at x
  double nearest = std::numeric_limits<double>::infinity(); ///< distance, other than 0
  std::size_t nearest_index = 0;

  /** \brief x is the median if what lies there outweighs all others (Vardi, Zhang). */
  bool
  isBalanced() const
  {
    return resultant.norm() <= here + 1e-13 * total;
  }
};

/** \brief Pull at x, with weights by the distance from x, which are kept in \a moved.
 */
Pull
pullAt(const Point& x,
       double inverse_radius,
       const Weighting* weighting,
       Distances& moved)
{
  Pull pull;
  for (std::size_t i = 0; i < moved.points.size(); ++i) {
    const Point offset = moved.points[i] - x;
    const double distance = offset.norm();
    const double weight =
        weighting == nullptr ? 1.0 : (*weighting)(distance * inverse_radius);
    moved.weights[i] = weight;
    pull.total += weight;
    pull.sum += weight * distance;
    if (distance == 0) {
      pull.here += weight;
      continue;
    }
    if (distance < pull.nearest) {
      pull.nearest = distance;
      pull.nearest_index = i;
    }
    const Point unit = offset / distance;
    const double stiffness = weight / distance;
    pull.resultant += weight * unit;
    pull.stiffness += stiffness;
    pull.curvature.noalias() -= stiffness * unit * unit.transpose();
  }
  pull.curvature.diagonal().array() += pull.stiffness;
  return pull;
}

/** \brief Weiszfeld's step from x: always to a smaller sum, but creeping along wires.
 */
Point
weiszfeldStep(const Pull& pull)
{
  return (1 - pull.here / pull.resultant.norm()) / pull.stiffness * pull.resultant;
}

/** \brief Newton's step from x, of at most \a longest, shortened until the sum falls;
 * Weiszfeld's where it does not. */
Point
newtonStep(const Point& x, const Pull& pull, double longest, const Distances& distances)
{
  Eigen::Matrix3d curvature = pull.curvature;
  curvature.diagonal().array() += 1e-10 * pull.stiffness; // all points on one line
  Point step = curvature.ldlt().solve(pull.resultant);
  const double length = step.norm();
  if (length > longest)
    step *= longest / length;
  const double rounding = 1e-14 * pull.sum, slope = pull.resultant.dot(step);
  for (double part = 1; part > 0.01; part /= 2)
    if (distances.sumFrom(x + part * step) <= pull.sum - 1e-4 * part * slope + rounding)
      return part * step;
  return weiszfeldStep(pull);
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

  // With weights there may be several local minima; which one is found is for
  // Weiszfeld's steps to say, Newton's only shorten the last bit of the way.
  const bool convex = weighting == nullptr;
  const double newton_from = convex ? size : 1e-3 * size;
  const double longest = convex ? size : 1e-2 * size;
  const double precise_enough = 1e-11 * size;
  constexpr int most_iterations = 1000;
  Distances distances{points, std::vector<double>(points.size())}, there = distances;
  std::size_t tried = points.size();
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    const Pull pull = pullAt(x, inverse_radius, weighting, distances);
    if (pull.isBalanced())
      return x;
    // The sum of distances has a kink at every neighbour, where no step arrives; ask
    // whether the nearest one is the median.
    if (pull.nearest_index != tried && pull.nearest < newton_from) {
      tried = pull.nearest_index;
      if (pullAt(points[tried], inverse_radius, weighting, there).isBalanced())
        return points[tried];
    }
    Point step = weiszfeldStep(pull);
    if (pull.here == 0 && step.norm() < newton_from)
      step = newtonStep(x, pull, longest, distances);
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
