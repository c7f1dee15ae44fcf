// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "edge_pairs.h"

#include <algorithm>
#include <vector>

#include "curves/ridges/sorted_kernels.h"

namespace linelet {

namespace {

// Pairs of a point and an edge count up to this many standard deviations.
constexpr double pair_reach = 3.5;
constexpr double pair_margin = 0.3;
// The pairs are collected again once the noise has changed by these factors.
constexpr double stale_share = 0.6;
constexpr double grown_share = 1.2;

} // namespace

EdgePairs::EdgePairs(const UniformGrid& grid)
    : grid_(grid), sorted_(std::make_shared<SortedArrays>(grid))
{
}

void
EdgePairs::collect(MixtureState& mixture)
{
  std::vector<SortedRun> runs;
  std::size_t count = 0;
  for (MixtureEdge& edge : mixture.edges) {
    edge.paired_noise = edge.noise;
    const double band = (pair_reach + pair_margin) * edge.noise,
                 reach = mixture.noise.fixed_radius + band;
    const Point middle = edge.from + 0.5 * edge.length * edge.direction;
    std::size_t most = count + SortedArrays::padding;
    runs.clear();
    grid_.forEachRun(
        middle, reach + 0.5 * edge.length, [&](std::size_t begin, std::size_t end) {
          runs.push_back({begin, end});
          most += end - begin;
        });
    index.makeRoom(most);
    for (auto& coordinate : at)
      coordinate.makeRoom(most);
    const EdgeShape shape = shapeOf(edge);
    NearEdge near;
    std::copy_n(shape.from, 3, near.from);
    std::copy_n(shape.direction, 3, near.direction);
    near.length = edge.length;
    near.reach = reach;
    edge.pairs_begin = count;
    count += sortedKernels().nearEdge(
        *sorted_,
        runs,
        near,
        index.data() + count,
        {at[0].data() + count, at[1].data() + count, at[2].data() + count});
    edge.pairs_end = count;
    if (mixture.noise.fixed_radius > band) {
      dropHollow(edge, mixture.noise.fixed_radius - band);
      count = edge.pairs_end;
    }
  }
  density.makeRoom(count + EdgePoints::padding);
  if (mixture.noise.fixed_radius > 0)
    for (auto* values : {&place, &residual, &spread})
      values->makeRoom(count + EdgePoints::padding);
}

void
EdgePairs::dropHollow(MixtureEdge& edge, double hollow)
{
  std::size_t kept = edge.pairs_begin;
  const Point to = edge.from + edge.length * edge.direction;
  for (std::size_t k = edge.pairs_begin; k < edge.pairs_end; ++k) {
    const Point x(at[0][k], at[1][k], at[2][k]);
    if (std::max((x - edge.from).squaredNorm(), (x - to).squaredNorm()) <
        hollow * hollow)
      continue;
    index[kept] = index[k];
    for (auto& coordinate : at)
      coordinate[kept] = coordinate[k];
    ++kept;
  }
  edge.pairs_end = kept;
}

bool
EdgePairs::areStale(const MixtureState& mixture) const
{
  double now = 0, then = 0;
  bool grown = false;
  for (const MixtureEdge& edge : mixture.edges) {
    now += edge.noise;
    then += edge.paired_noise;
    grown = grown || edge.noise > grown_share * edge.paired_noise;
  }
  // Uniform noise only shrinks while the fit settles; varying noise can grow too.
  return now < stale_share * then || (mixture.noise.varied && grown);
}

EdgePoints
EdgePairs::pointsOf(const MixtureEdge& edge) const
{
  const std::size_t begin = edge.pairs_begin;
  return {edge.pairs_end - begin,
          at[0].data() + begin,
          at[1].data() + begin,
          at[2].data() + begin};
}

EdgeShape
shapeOf(const MixtureEdge& edge)
{
  EdgeShape shape;
  for (int axis = 0; axis < 3; ++axis) {
    shape.from[axis] = edge.from[axis];
    shape.direction[axis] = edge.direction[axis];
  }
  shape.length = edge.length;
  shape.variance = edge.noise * edge.noise;
  shape.factor = 0;
  // If the edge is short compared with the noise, the integral of the normal density
  // along it is itself close to normal.
  shape.is_short = edge.length < 1.2 * edge.noise;
  return shape;
}

} // namespace linelet
