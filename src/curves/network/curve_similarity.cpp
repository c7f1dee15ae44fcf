// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "curve_similarity.h"

#include <algorithm>
#include <cmath>

#include <linelet/tensor/point_moments.h>
#include <linelet/tensor/shape_factors.h>

namespace linelet {

namespace {

constexpr std::size_t looked_at = 200;
constexpr std::size_t neighbors_looked_at = 2000; // of each, spread over all of them
constexpr double least_linearity = 0.3;

/** \brief Whether \a nodes lie within \a tolerance of \a path, in the order of its own
 * nodes. */
bool
follow(const Points& nodes, const Points& path, double tolerance)
{
  std::size_t at = 0;
  for (const Point& node : nodes) {
    const auto squaredTo = [&](std::size_t k) {
      return (path[k] - node).squaredNorm();
    };
    double squared = squaredTo(at);
    for (std::size_t k = at + 1;
         k < path.size() && (path[k] - path[at]).norm() < 2 * tolerance;
         ++k)
      if (squaredTo(k) <= squared) {
        squared = squaredTo(k);
        at = k;
      }
    if (squared > tolerance * tolerance)
      return false;
  }
  return true;
}

/** \brief Whether two curves take the same course: both closed or both open, and every
 * node of one lies beside the other, in the same order. */
bool
ofOneCourse(const ModelCurve& a, const ModelCurve& b, double tolerance)
{
  if (a.closed != b.closed || std::abs(length(a) - length(b)) > 0.1 * length(b))
    return false;
  Points path = resampled(b, 0.5 * tolerance).nodes;
  if (a.closed) {
    std::size_t nearest = 0;
    for (std::size_t k = 1; k < path.size(); ++k)
      if ((path[k] - a.nodes.front()).squaredNorm() <
          (path[nearest] - a.nodes.front()).squaredNorm())
        nearest = k;
    std::rotate(
        path.begin(), path.begin() + static_cast<std::ptrdiff_t>(nearest), path.end());
    path.push_back(path.front());
  }
  if (follow(a.nodes, path, tolerance))
    return true;
  std::reverse(path.begin(), path.end());
  return follow(a.nodes, path, tolerance);
}

} // namespace

bool
ofOneCourse(const ModelCurves& some, const ModelCurves& others, double tolerance)
{
  if (some.size() != others.size())
    return false;
  std::vector<char> used(others.size(), 0);
  return std::all_of(some.begin(), some.end(), [&](const ModelCurve& curve) {
    for (std::size_t k = 0; k < others.size(); ++k)
      if (!used[k] && ofOneCourse(curve, others[k], tolerance)) {
        used[k] = 1;
        return true;
      }
    return false;
  });
}

bool
looksLinear(const Points& points, const UniformGrid& grid, double size)
{
  std::vector<double> best;
  const std::size_t stride = points.size() / looked_at;
  for (std::size_t i = 0; i < points.size(); i += stride) {
    double linearity = 0;
    for (const double radius : {2 * size, 4 * size}) {
      PointMoments moments;
      std::size_t near = 0;
      grid.forEachRun(points[i], radius, [&](std::size_t begin, std::size_t end) {
        near += end - begin;
      });
      const std::size_t step = near / neighbors_looked_at + 1;
      std::size_t skipped = 0; // sorted indices of the next run
      grid.forEachRun(points[i], radius, [&](std::size_t begin, std::size_t end) {
        std::size_t sorted_index = begin + skipped;
        for (; sorted_index < end; sorted_index += step) {
          const Point v = grid.sortedPoints()[sorted_index] - points[i];
          if (v.squaredNorm() <= radius * radius)
            moments.add(v);
        }
        skipped = sorted_index - end;
      });
      linearity = std::max(linearity, linearityOf(moments.covariance().matrix()));
    }
    best.push_back(linearity);
  }
  const auto middle = best.begin() + static_cast<std::ptrdiff_t>(best.size() / 2);
  std::nth_element(best.begin(), middle, best.end());
  return *middle >= least_linearity;
}

} // namespace linelet
