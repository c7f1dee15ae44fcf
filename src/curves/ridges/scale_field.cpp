// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "scale_field.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <linelet/tensor/point_moments.h>
#include <linelet/tensor/shape_factors.h>

#include "search/nearest_walk.h"
#include "search/sort_indices.h"

namespace linelet {

namespace {

constexpr std::size_t spacing_neighbors = 6;
constexpr std::size_t smoothing_neighbors = 12;
// Points whose neighborhood is at least this linear show the spacing along curves; they
// must be at least this share of all points.
constexpr double least_linearity = 0.6;
constexpr double least_linear = 0.3;

using Neighbors = std::vector<UniformGrid::Neighbor>;

/** \brief Calls visit(index, neighbors) for the nearest neighbors of every point, near
 * to far, ties by index. */
template <class Visit>
void
forEachNearest(const NeighborSearch* search,
               const Points& points,
               double scale_unit,
               const Visit& visit)
{
  if (search == nullptr) {
    const UniformGrid grid(points, scale_unit);
    NearestWalk walk(points, grid, smoothing_neighbors + 1);
    const Indices& all = grid.inputIndices();
    walk(all.data(), all.data() + all.size(), visit);
    return;
  }
  Indices found;
  Neighbors nearest;
  for (std::size_t i = 0; i < points.size(); ++i) {
    search->nearest(points[i], smoothing_neighbors + 1, found);
    nearest.clear();
    for (const Index j : found)
      nearest.emplace_back((points[j] - points[i]).squaredNorm(), j);
    std::sort(nearest.begin(), nearest.end());
    visit(static_cast<Index>(i), nearest);
  }
}

} // namespace

ScaleField::ScaleField(const Points& points,
                       double scale_unit,
                       double least_spread,
                       const NeighborSearch* search)
    : unit_(scale_unit)
{
  std::vector<double> logarithms(points.size());
  std::vector<Indices> near(points.size());
  forEachNearest(search, points, scale_unit, [&](Index i, const Neighbors& nearest) {
    // The nearest is the point itself, or a duplicate.
    const std::size_t sixth = std::min(spacing_neighbors, nearest.size() - 1);
    const double spacing = std::sqrt(nearest[sixth].first) / scale_unit;
    logarithms[i] = std::log(std::clamp(spacing, 1 / widest(), widest()));
    near[i].reserve(nearest.size());
    for (const auto& [squared, j] : nearest)
      near[i].push_back(j);
    sortIndices(near[i]);
  });
  std::vector<double> linear;
  auto values = std::make_shared<std::vector<double>>();
  for (std::size_t i = 0; i < points.size(); ++i) {
    double sum = 0;
    PointMoments moments;
    for (const Index j : near[i]) {
      sum += logarithms[j];
      moments.add(points[j] - points[i]);
    }
    values->push_back(std::exp(sum / static_cast<double>(moments.count)));
    if (linearityOf(moments.covariance().matrix()) >= least_linearity)
      linear.push_back(values->back());
  }
  if (static_cast<double>(linear.size()) >=
      least_linear * static_cast<double>(points.size())) {
    std::sort(linear.begin(), linear.end());
    spread_ = linear[linear.size() * 9 / 10] / linear[linear.size() / 10];
  }
  if (spread_ < least_spread)
    return;
  tree_ = std::make_shared<KdTree>(points);
  values_ = std::move(values);
}

// Also called for places far from all points, where a grid search would visit many
// empty rows.
double
ScaleField::at(const Point& x) const
{
  if (!values_)
    return 1;
  thread_local Indices nearest;
  tree_->nearest(x + origin_, 1, nearest);
  return nearest.empty() ? 1 : (*values_)[nearest.front()];
}

} // namespace linelet
