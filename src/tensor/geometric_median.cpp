// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "geometric_median.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Core>

// The loops over points, compiled for every instruction set that matters.
#if defined(__GNUC__) && __GNUC__ >= 12 && !defined(__clang__) &&                      \
    defined(__x86_64__) && defined(__linux__)
#define LINELET_ON_VECTORS                                                             \
  __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define LINELET_ON_VECTORS
#endif

namespace linelet {

namespace {

/** \brief Places and weights of points, coordinate by coordinate. */
struct Columns {
  std::size_t count;
  const double *x, *y, *z;
  double* distance;
  double* weight;
};

/** \brief Distances of the points from a place. */
LINELET_ON_VECTORS void
fillDistances(const Columns& points, double x, double y, double z)
{
  double* const distance = points.distance;
#pragma omp simd
  for (std::size_t i = 0; i < points.count; ++i) {
    const double dx = points.x[i] - x, dy = points.y[i] - y, dz = points.z[i] - z;
    distance[i] = std::sqrt(dx * dx + dy * dy + dz * dz);
  }
}

/** \brief 0.01 / x^2 beyond x = 0.1, the default weights of centroids. */
LINELET_ON_VECTORS void
fillQuadraticInverse(const Columns& points, double inverse_radius)
{
#pragma omp simd
  for (std::size_t i = 0; i < points.count; ++i) {
    const double x = points.distance[i] * inverse_radius;
    const double root = 0.1 / std::max(x, 0.1);
    points.weight[i] = root * root;
  }
}

LINELET_ON_VECTORS double
weightedSum(const Columns& points)
{
  double sum = 0;
#pragma omp simd reduction(+ : sum)
  for (std::size_t i = 0; i < points.count; ++i)
    sum += points.weight[i] * points.distance[i];
  return sum;
}

/** \brief Sums over the points seen from a place, u unit vectors to them. */
struct PullSums {
  double x, y, z;                ///< w u
  double stiffness;              ///< w / d
  double xx, xy, xz, yy, yz, zz; ///< w / d u (x) u
  double total;                  ///< w
  double sum;                    ///< w d
  double here;                   ///< w of those at the place
  double nearest;                ///< distance of the nearest one elsewhere
};

LINELET_ON_VECTORS void
pullSums(const Columns& points, double x, double y, double z, PullSums& sums)
{
  double sx = 0, sy = 0, sz = 0, stiffness = 0, xx = 0, xy = 0, xz = 0, yy = 0, yz = 0,
         zz = 0, total = 0, sum = 0, here = 0;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double nearest = infinity;
#pragma omp simd reduction(+ : sx, sy, sz, stiffness, xx, xy, xz, yy, yz, zz, total,   \
                               sum, here) reduction(min : nearest)
  for (std::size_t i = 0; i < points.count; ++i) {
    const double d = points.distance[i], w = points.weight[i];
    const bool away = d > 0;
    const double inverse = (away ? 1.0 : 0.0) / (away ? d : 1.0);
    const double ux = (points.x[i] - x) * inverse, uy = (points.y[i] - y) * inverse,
                 uz = (points.z[i] - z) * inverse;
    const double stiff = w * inverse;
    const double tx = stiff * ux, ty = stiff * uy, tz = stiff * uz;
    total += w;
    sum += w * d;
    here += away ? 0 : w;
    nearest = std::min(nearest, away ? d : infinity);
    sx += w * ux;
    sy += w * uy;
    sz += w * uz;
    stiffness += stiff;
    xx += tx * ux;
    xy += tx * uy;
    xz += tx * uz;
    yy += ty * uy;
    yz += ty * uz;
    zz += tz * uz;
  }
  sums = {sx, sy, sz, stiffness, xx, xy, xz, yy, yz, zz, total, sum, here, nearest};
}

/** \brief The terms of Weiszfeld's and Newton's steps at a place x. */
struct Pull {
  Point resultant;           ///< sum of w_i u_i, u_i unit vectors to neighbors
  double stiffness;          ///< sum of w_i / d_i
  Eigen::Matrix3d curvature; ///< sum of w_i / d_i (1 - u (x) u)
  double total;              ///< sum of w_i
  double sum;                ///< sum of w_i d_i
  double here;               ///< weight of the neighbors that lie at x
  double nearest;            ///< distance, other than 0
  std::size_t nearest_index;

  /** \brief x is the median if the points there outweigh all others (Vardi, Zhang). */
  bool
  isBalanced() const
  {
    return resultant.norm() <= here + 1e-13 * total;
  }
};

/** \brief The points, seen from one place after the other. */
class Neighborhood {
public:
  Neighborhood(const Points& points, double inverse_radius, const Weighting* weighting)
      : count_(points.size()),
        columns_(5 * points.size(), 1.0),
        inverse_radius_(inverse_radius),
        weighting_(weighting)
  {
    for (std::size_t i = 0; i < count_; ++i)
      for (std::size_t axis = 0; axis < 3; ++axis)
        columns_[axis * count_ + i] = points[i][static_cast<Eigen::Index>(axis)];
  }

  /** \brief Distance of the farthest point from \a x. */
  double
  size(const Point& x)
  {
    const Columns points = columns();
    fillDistances(points, x.x(), x.y(), x.z());
    return *std::max_element(points.distance, points.distance + count_);
  }

  /** \brief Pull at x, with weights by the distance from x, which are kept. */
  Pull
  pullAt(const Point& x)
  {
    const Columns points = columns();
    fillDistances(points, x.x(), x.y(), x.z());
    weigh(points);
    PullSums s;
    pullSums(points, x.x(), x.y(), x.z(), s);
    Pull pull;
    pull.resultant = {s.x, s.y, s.z};
    pull.stiffness = s.stiffness;
    pull.curvature << s.xx, s.xy, s.xz, s.xy, s.yy, s.yz, s.xz, s.yz, s.zz;
    pull.curvature = -pull.curvature;
    pull.curvature.diagonal().array() += s.stiffness;
    pull.total = s.total;
    pull.sum = s.sum;
    pull.here = s.here;
    pull.nearest = s.nearest;
    pull.nearest_index = static_cast<std::size_t>(
        std::find(points.distance, points.distance + count_, s.nearest) -
        points.distance);
    return pull;
  }

  /** \brief Sum of distances from \a x, by the weights of the last pull. */
  double
  sumFrom(const Point& x)
  {
    const Columns points = columns();
    fillDistances(points, x.x(), x.y(), x.z());
    return weightedSum(points);
  }

private:
  Columns
  columns()
  {
    double* const values = columns_.data();
    return {count_,
            values,
            values + count_,
            values + 2 * count_,
            values + 3 * count_,
            values + 4 * count_};
  }

  void
  weigh(const Columns& points) const
  {
    if (weighting_ == nullptr)
      return; // all 1
    if (weighting_->kernel() == Kernel::QuadraticInverse)
      fillQuadraticInverse(points, inverse_radius_);
    else
      for (std::size_t i = 0; i < count_; ++i)
        points.weight[i] = (*weighting_)(points.distance[i] * inverse_radius_);
  }

  std::size_t count_;
  std::vector<double> columns_; // x, y, z, distance, weight
  double inverse_radius_;
  const Weighting* weighting_;
};

/** \brief Weiszfeld's step from x: always descends, but creeps along wires. */
Point
weiszfeldStep(const Pull& pull)
{
  return (1 - pull.here / pull.resultant.norm()) / pull.stiffness * pull.resultant;
}

/** \brief Newton's step from x, of at most \a longest, shortened until the sum falls;
 * Weiszfeld's where it does not. */
Point
newtonStep(const Point& x, const Pull& pull, double longest, Neighborhood& points)
{
  Eigen::Matrix3d curvature = pull.curvature;
  curvature.diagonal().array() += 1e-10 * pull.stiffness; // all points on one line
  Point step = curvature.ldlt().solve(pull.resultant);
  const double length = step.norm();
  if (length > longest)
    step *= longest / length;
  const double rounding = 1e-14 * pull.sum, slope = pull.resultant.dot(step);
  for (double part = 1; part > 0.01; part /= 2)
    if (points.sumFrom(x + part * step) <= pull.sum - 1e-4 * part * slope + rounding)
      return part * step;
  return weiszfeldStep(pull);
}

} // namespace

Point
geometricMedian(const Points& points,
                const Point& start,
                double inverse_radius,
                const Weighting* weighting)
{
  Point x = start;
  Neighborhood neighborhood(points, inverse_radius, weighting);
  const double size = neighborhood.size(x);
  if (size == 0)
    return x;

  // With weights there may be several local minima. Weiszfeld's steps choose one,
  // Newton's only finish the job.
  const bool convex = weighting == nullptr;
  const double newton_from = convex ? size : 1e-3 * size;
  const double longest = convex ? size : 1e-2 * size;
  const double precise_enough = 1e-11 * size;
  constexpr int most_iterations = 1000;
  std::size_t tried = points.size();
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    const Pull pull = neighborhood.pullAt(x);
    if (pull.isBalanced())
      return x;
    // The sum of distances has a kink at every neighbor, which steps never reach: test
    // whether the nearest one is the median.
    bool moved = false;
    if (pull.nearest_index != tried && pull.nearest < newton_from) {
      tried = pull.nearest_index;
      if (neighborhood.pullAt(points[tried]).isBalanced())
        return points[tried];
      moved = true;
    }
    Point step = weiszfeldStep(pull);
    if (pull.here == 0 && step.norm() < newton_from) {
      if (moved && !convex)
        neighborhood.pullAt(x); // its weights
      step = newtonStep(x, pull, longest, neighborhood);
    }
    x += step;
    if (step.norm() <= precise_enough)
      break;
  }
  return x;
}

} // namespace linelet
