// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>

#include "curves/ridges/sorted_kernels.h"
#include "em_fit.h"
#include "em_kernels.h"

namespace linelet {

namespace {

// Pairs of a point and an edge count up to this many standard deviations.
constexpr double pair_reach = 3.5;
constexpr double pair_margin = 0.3;
// The pairs are collected anew when the noise has changed by these factors.
constexpr double stale_share = 0.6;
constexpr double grown_share = 1.2;

} // namespace

void
EmFitter::collectPairs()
{
  std::vector<SortedRun> runs;
  std::size_t count = 0;
  for (Edge& edge : edges_) {
    edge.paired_noise = edge.noise;
    const double band = (pair_reach + pair_margin) * edge.noise,
                 reach = fixed_radius_ + band;
    const Point middle = edge.from + 0.5 * edge.length * edge.direction;
    std::size_t most = count + SortedArrays::padding;
    runs.clear();
    grid_.forEachRun(
        middle, reach + 0.5 * edge.length, [&](std::size_t begin, std::size_t end) {
          runs.push_back({begin, end});
          most += end - begin;
        });
    pair_index_.makeRoom(most);
    for (auto& coordinate : pair_at_)
      coordinate.makeRoom(most);
    const EdgeShape shape = shapeOf(edge);
    NearEdge near;
    std::copy_n(shape.from, 3, near.from);
    std::copy_n(shape.direction, 3, near.direction);
    near.length = edge.length;
    near.reach = reach;
    edge.pairs_begin = count;
    count += sortedKernels().nearEdge(*sorted_,
                                      runs,
                                      near,
                                      pair_index_.data() + count,
                                      {pair_at_[0].data() + count,
                                       pair_at_[1].data() + count,
                                       pair_at_[2].data() + count});
    edge.pairs_end = count;
    if (fixed_radius_ > band) {
      dropHollow(edge, fixed_radius_ - band);
      count = edge.pairs_end;
    }
  }
  pair_density_.makeRoom(count + EdgePoints::padding);
  if (fixed_radius_ > 0)
    for (auto* values : {&pair_place_, &pair_residual_, &pair_spread_})
      values->makeRoom(count + EdgePoints::padding);
}

bool
EmFitter::pairsAreStale() const
{
  double now = 0, then = 0;
  bool grown = false;
  for (const Edge& edge : edges_) {
    now += edge.noise;
    then += edge.paired_noise;
    grown = grown || edge.noise > grown_share * edge.paired_noise;
  }
  // Noise of one width shrinks while the fit settles; widths that vary grow as well.
  return now < stale_share * then || (varied_ && grown);
}

void
EmFitter::densitiesOf(const Edge& edge)
{
  EdgeShape shape = shapeOf(edge);
  const double spread = 2 * M_PI * shape.variance;
  const double across = 1 / (frame_.dimensions == 3 ? spread : std::sqrt(spread));
  shape.factor =
      edge.weight * across *
      (shape.is_short
           ? 1 / std::sqrt(2 * M_PI * (shape.variance + edge.length * edge.length / 12))
           : 1 / edge.length);
  emKernels().densities(shape, pointsOf(edge), pair_density_.data() + edge.pairs_begin);
}

void
EmFitter::expect()
{
  const double background = outlier_share_ / frame_.volume;
  const std::size_t n = points_.size();
  density_.assign(n + EdgePoints::padding, background);
  // A kernel writes beyond its edge, where the next edge is yet to write.
  for (const Edge& edge : edges_) {
    if (fixed_radius_ > 0)
      fixedRadiusDensitiesOf(edge);
    else
      densitiesOf(edge);
    for (std::size_t k = edge.pairs_begin; k < edge.pairs_end; ++k)
      density_[pair_index_[k]] += pair_density_[k];
  }

  log_likelihood_ = emKernels().invert(density_.data(), n);
  edge_count_.resize(edges_.size());
  double outliers = static_cast<double>(n);
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    const std::size_t begin = edges_[e].pairs_begin;
    edge_count_[e] = emKernels().share(density_.data(),
                                       pair_index_.data() + begin,
                                       pair_density_.data() + begin,
                                       edges_[e].pairs_end - begin);
    outliers -= edge_count_[e];
  }
  if (fixed_radius_ > 0)
    measureInformation();
  outlier_share_ = std::clamp(outliers / static_cast<double>(n), 1e-3, 1 - 1e-3);
}

EdgeShape
EmFitter::shapeOf(const Edge& edge) const
{
  EdgeShape shape;
  for (int axis = 0; axis < 3; ++axis) {
    shape.from[axis] = edge.from[axis];
    shape.direction[axis] = edge.direction[axis];
  }
  shape.length = edge.length;
  shape.variance = edge.noise * edge.noise;
  shape.factor = 0;
  // Where the edge is short beside the noise, the integral of the normal density along
  // it is a normal density of its own.
  shape.is_short = edge.length < 1.2 * edge.noise;
  return shape;
}

EdgePoints
EmFitter::pointsOf(const Edge& edge) const
{
  const std::size_t begin = edge.pairs_begin;
  return {edge.pairs_end - begin,
          pair_at_[0].data() + begin,
          pair_at_[1].data() + begin,
          pair_at_[2].data() + begin};
}

} // namespace linelet
