// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/hazards/fall_in.h"

#include <algorithm>
#include <cmath>

#include <linelet/search/uniform_grid.h>

#include "powerline/hazards/wire_cells.h"

namespace linelet::powerline {

namespace {

constexpr double lowest_tree = 3; // meters; what is lower is a bush

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

} // namespace

std::vector<FallIn>
findFallIn(const PowerLineNetwork& network,
           const std::vector<WireCurve>& curves,
           const Surroundings& surroundings,
           const ClearanceLimits& limits)
{
  // Vegetation in plan, each point with its height above the terrain.
  Points plan;
  std::vector<double> heights;
  Indices of;
  double tallest = 0;
  for (std::size_t i = 0; i < surroundings.points.size(); ++i) {
    const Point& p = surroundings.points[i];
    const double height = p.z() - network.ground.heightAt(p.x(), p.y());
    if (surroundings.kinds[i] != HazardKind::Vegetation || !(height > lowest_tree))
      continue;
    plan.emplace_back(p.x(), p.y(), 0);
    heights.push_back(height);
    of.push_back(static_cast<Index>(i));
    tallest = std::max(tallest, height);
  }
  std::vector<FallIn> falls;
  if (plan.empty() || network.wires.empty())
    return falls;
  const double margin = limits.of(HazardKind::FallIn).low;
  const WireCells cells(network.wires, tallest + margin);
  const UniformGrid grid(plan, crownWidth(tallest) / 2);
  for (std::size_t k = 0; k < plan.size(); ++k) {
    const auto& near = cells.near(plan[k]);
    if (near.empty())
      continue;
    bool highest = true; // equals: the first of them
    grid.forEachWithin(plan[k], crownWidth(heights[k]) / 2, [&](Index j, double) {
      highest =
          highest && (heights[j] < heights[k] || (heights[j] == heights[k] && j >= k));
    });
    if (!highest)
      continue;
    const Point& top = surroundings.points[of[k]];
    FallIn fall = fallFrom(top, top.z() - heights[k], network.wires, curves, near);
    fall.severity = limits.severity(HazardKind::FallIn, fall.gap);
    if (fall.severity != Severity::None)
      falls.push_back(fall);
  }
  std::stable_sort(falls.begin(), falls.end(), [](const FallIn& a, const FallIn& b) {
    return a.gap < b.gap;
  });
  for (std::size_t k = 0; k < falls.size(); ++k)
    falls[k].id = static_cast<int>(k) + 1;
  return falls;
}

} // namespace linelet::powerline
