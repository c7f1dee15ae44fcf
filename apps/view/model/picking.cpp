// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "picking.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace linelet::view {

namespace {

struct Candidate {
  double depth, offset;
  Index index;
};

} // namespace

Index
pick(const UniformGrid& grid, const Ray& ray, double depth)
{
  const Points& points = grid.sortedPoints();
  const auto reachAt = [&](double s) { return ray.radius + ray.spread * s; };
  std::vector<Candidate> candidates;
  double deepest = depth; // where nothing more can be found
  const double least = 1e-6 * depth;
  // Balls along the axis, each around a slice of the cone that is as long as it is
  // wide.
  for (double s = 0; s <= deepest;) {
    const double step = std::max(least, 2 * reachAt(s));
    const Point center = ray.origin + (s + step / 2) * ray.direction;
    const double around = std::hypot(step / 2, reachAt(s + step));
    grid.forEachRun(center, around, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const Point offset = points[i] - ray.origin;
        const double at = offset.dot(ray.direction);
        if (at < s || at >= s + step || at > depth)
          continue;
        const double beside = (offset - at * ray.direction).norm();
        if (beside > reachAt(at))
          continue;
        candidates.push_back({at, beside, grid.inputIndices()[i]});
        deepest = std::min(deepest, at + 2 * reachAt(at));
      }
    });
    s += step;
  }
  const Candidate* best = nullptr;
  for (const Candidate& one : candidates)
    if (one.depth <= deepest &&
        (best == nullptr || one.offset < best->offset ||
         (one.offset == best->offset && one.index < best->index)))
      best = &one;
  return best == nullptr ? UniformGrid::none : best->index;
}

Indices
randomSubset(std::size_t count, std::size_t most)
{
  Indices all(count);
  std::iota(all.begin(), all.end(), Index{0});
  if (count <= most)
    return all;
  Indices chosen;
  chosen.reserve(most);
  std::mt19937 random(1);
  std::sample(all.begin(), all.end(), std::back_inserter(chosen), most, random);
  return chosen;
}

} // namespace linelet::view
