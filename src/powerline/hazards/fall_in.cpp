// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/hazards/fall_in.h"

#include <algorithm>
#include <cmath>

#include <linelet/search/uniform_grid.h>
#include <linelet/support/threads.h>

#include "powerline/hazards/wire_cells.h"
#include "support/parallel_failure.h"

namespace linelet::powerline {

namespace {

constexpr double lowest_tree = 3; // meters; anything lower is a bush

double
crownWidth(double height)
{
  return 2.51503 + 0.00901 * height * height;
}

/** The wire nearest to the foot of a tree. */
FallIn
fallFrom(const Point& top,
         double ground,
         const std::vector<Wire>& wires,
         const std::vector<WireCurve>& curves,
         const std::vector<std::uint32_t>& near)
{
  FallIn fall;
  fall.top = top;
  fall.foot = Point(top.x(), top.y(), ground);
  fall.height = top.z() - ground;
  fall.distance = 1e300;
  for (const std::uint32_t w : near) {
    const Point at = curves[w].at(curves[w].nearest(fall.foot));
    if (const double distance = (at - fall.foot).norm(); distance < fall.distance) {
      fall.distance = distance;
      fall.at = at;
      fall.wire = wires[w].id;
      fall.span = wires[w].span;
      fall.circuit = wires[w].circuit;
    }
  }
  fall.gap = fall.distance - fall.height;
  return fall;
}

/** Vegetation in plan. */
struct Canopy {
  Points plan;
  std::vector<double> heights; ///< above the terrain
  Indices of;                  ///< the surroundings
  double tallest = 0;
};

Canopy
canopyOf(const PowerLineNetwork& network,
         const Surroundings& surroundings,
         unsigned threads)
{
  const Points& points = surroundings.points;
  std::vector<double> heights(points.size(), 0);
  const auto count = static_cast<std::ptrdiff_t>(points.size());
#pragma omp parallel for schedule(static) num_threads(threadCount(threads))
  for (std::ptrdiff_t k = 0; k < count; ++k) {
    const auto i = static_cast<std::size_t>(k);
    if (surroundings.kinds[i] == HazardKind::Vegetation)
      heights[i] =
          points[i].z() - network.ground.heightAt(points[i].x(), points[i].y());
  }
  Canopy canopy;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!(heights[i] > lowest_tree))
      continue;
    canopy.plan.emplace_back(points[i].x(), points[i].y(), 0);
    canopy.heights.push_back(heights[i]);
    canopy.of.push_back(static_cast<Index>(i));
    canopy.tallest = std::max(canopy.tallest, heights[i]);
  }
  return canopy;
}

/** Finds the tops of trees. */
class Tops {
public:
  Tops(const UniformGrid& grid, const std::vector<double>& heights)
      : grid_(grid), heights_(heights)
  {
  }

  /** Whether nothing higher stands within half a crown's width of the point at \a place
   * in the grid; in a tie the first counts as the highest. */
  bool
  isTop(std::size_t place) const
  {
    const Index k = grid_.inputIndices()[place];
    const Point& p = grid_.sortedPoints()[place];
    const double radius = crownWidth(heights_[k]) / 2;
    // Usually one of its neighbors in the grid decides.
    const std::size_t end = std::min(grid_.size(), place + beside + 1);
    for (std::size_t other = place < beside ? 0 : place - beside; other < end; ++other)
      if (isHigher(grid_.inputIndices()[other], k) &&
          (grid_.sortedPoints()[other] - p).squaredNorm() <= radius * radius)
        return false;
    bool top = true;
    grid_.forEachWithin(
        p, radius, [&](Index j, double) { top = top && !isHigher(j, k); });
    return top;
  }

private:
  static constexpr std::size_t beside = 8;

  bool
  isHigher(Index j, Index k) const
  {
    return heights_[j] > heights_[k] || (heights_[j] == heights_[k] && j < k);
  }

  const UniformGrid& grid_;
  const std::vector<double>& heights_;
};

} // namespace

std::vector<FallIn>
findFallIn(const PowerLineNetwork& network,
           const std::vector<WireCurve>& curves,
           const Surroundings& surroundings,
           const ClearanceLimits& limits,
           unsigned threads)
{
  std::vector<FallIn> falls;
  if (network.wires.empty())
    return falls;
  const Canopy canopy = canopyOf(network, surroundings, threads);
  if (canopy.plan.empty())
    return falls;
  const double margin = limits.of(HazardKind::FallIn).low;
  const WireCells cells(network.wires, canopy.tallest + margin);
  const UniformGrid grid(canopy.plan, crownWidth(canopy.tallest) / 2);
  const Tops tops(grid, canopy.heights);
  Indices trees;
  ParallelFailure failure;
  const auto count = static_cast<std::ptrdiff_t>(grid.size());
#pragma omp parallel for schedule(dynamic, 1024) num_threads(threadCount(threads))
  for (std::ptrdiff_t k = 0; k < count; ++k)
    failure.guard([&] {
      const auto place = static_cast<std::size_t>(k);
      if (cells.near(grid.sortedPoints()[place]).empty() || !tops.isTop(place))
        return;
#pragma omp critical(linelet_fall_in)
      trees.push_back(grid.inputIndices()[place]);
    });
  failure.rethrow();
  std::sort(trees.begin(), trees.end());
  falls.resize(trees.size());
  const auto number = static_cast<std::ptrdiff_t>(trees.size());
#pragma omp parallel for schedule(dynamic, 16) num_threads(threadCount(threads))
  for (std::ptrdiff_t t = 0; t < number; ++t) {
    const auto i = static_cast<std::size_t>(t);
    const Index k = trees[i];
    const Point& top = surroundings.points[canopy.of[k]];
    falls[i] = fallFrom(top,
                        top.z() - canopy.heights[k],
                        network.wires,
                        curves,
                        cells.near(canopy.plan[k]));
    falls[i].severity = limits.severity(HazardKind::FallIn, falls[i].gap);
  }
  falls.erase(std::remove_if(
                  falls.begin(),
                  falls.end(),
                  [](const FallIn& fall) { return fall.severity == Severity::None; }),
              falls.end());
  std::stable_sort(falls.begin(), falls.end(), [](const FallIn& a, const FallIn& b) {
    return a.gap < b.gap;
  });
  for (std::size_t k = 0; k < falls.size(); ++k)
    falls[k].id = static_cast<int>(k) + 1;
  return falls;
}

} // namespace linelet::powerline
