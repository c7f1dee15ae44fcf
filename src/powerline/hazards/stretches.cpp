// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/hazards/stretches.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>
#include <unordered_map>

namespace linelet::powerline {

namespace {

constexpr double gap = 1;         // meters of wire between stretches that are joined
constexpr double vertex_step = 2; // meters between vertices of a stretch
constexpr double cell = 0.5;      // meters, of areas and volumes

using Plan = Eigen::Vector2d;

double
cross(const Plan& a, const Plan& b)
{
  return a.x() * b.y() - a.y() * b.x();
}

/** Convex hull, counterclockwise, closed (Andrew's monotone chain, 1979). */
std::vector<Plan>
hull(std::vector<Plan> points)
{
  std::sort(points.begin(), points.end(), [](const Plan& a, const Plan& b) {
    return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
  });
  std::vector<Plan> out;
  const auto add = [&](const Plan& p, std::size_t least) {
    while (out.size() >= least + 2 &&
           cross(out.back() - out[out.size() - 2], p - out.back()) <= 0)
      out.pop_back();
    out.push_back(p);
  };
  for (const Plan& p : points)
    add(p, 0);
  const std::size_t lower = out.size() - 1;
  for (auto p = points.rbegin() + 1; p < points.rend(); ++p)
    add(*p, lower);
  return out;
}

/** Around cells of the places, so that even a single place has an area. */
Points
outlineOf(const std::vector<Approach>& places)
{
  std::vector<Plan> corners;
  double height = 0;
  for (const Approach& near : places) {
    height += near.place.z() / static_cast<double>(places.size());
    for (const double x : {-0.5, 0.5})
      for (const double y : {-0.5, 0.5})
        corners.push_back(near.place.head<2>() + cell * Plan(x, y));
  }
  Points outline;
  for (const Plan& p : hull(std::move(corners)))
    outline.emplace_back(p.x(), p.y(), height);
  return outline;
}

/** Area of the cells in plan with vegetation that is too close, and the volume from its
 * highest point there down to where the limit ends, or the terrain. */
void
measureCut(const PowerLineNetwork& network,
           const WireCurve& curve,
           double limit,
           const std::vector<Approach>& places,
           Encroachment& out)
{
  std::unordered_map<std::uint64_t, const Approach*> highest;
  for (const Approach& near : places) {
    const auto column = static_cast<std::int64_t>(std::floor(near.place.x() / cell));
    const auto row = static_cast<std::int64_t>(std::floor(near.place.y() / cell));
    const Approach*& top = highest[static_cast<std::uint64_t>(column) << 32 ^
                                   (static_cast<std::uint64_t>(row) & 0xffffffffU)];
    if (top == nullptr || near.place.z() > top->place.z())
      top = &near;
  }
  out.area = cell * cell * static_cast<double>(highest.size());
  std::vector<double>
      depths; // sorted before summing, as the order of a hash table is arbitrary
  for (const auto& [key, top] : highest) {
    const Point wire = curve.at(top->along);
    const double beside = (wire - top->place).head<2>().norm();
    const double lowest =
        wire.z() - std::sqrt(std::max(0.0, limit * limit - beside * beside));
    const double ground = network.ground.heightAt(top->place.x(), top->place.y());
    const double floor = ground > lowest ? ground : lowest;
    depths.push_back(std::max(0.0, top->place.z() - floor));
  }
  std::sort(depths.begin(), depths.end());
  for (const double depth : depths)
    out.volume += cell * cell * depth;
}

Points
lineOf(const WireCurve& curve, double from, double to)
{
  const int pieces =
      std::max(1, static_cast<int>(std::ceil((to - from) / vertex_step)));
  Points line;
  for (int k = 0; k <= pieces; ++k)
    line.push_back(curve.at(from + (to - from) * k / pieces));
  return line;
}

} // namespace

Approach
approach(const WireCurve& curve, const Point& place, double limit)
{
  Approach near{1, 0, 0, 0, place};
  near.along = curve.nearest(place);
  near.distance = (curve.at(near.along) - place).norm();
  if (near.distance < limit)
    std::tie(near.from, near.to) = curve.within(place, limit);
  return near;
}

void
appendStretches(const PowerLineNetwork& network,
                const WireCurve& curve,
                const Wire& wire,
                HazardKind kind,
                int other,
                const ClearanceLimits& limits,
                std::vector<Approach> approaches,
                std::vector<Encroachment>& out)
{
  std::sort(approaches.begin(),
            approaches.end(),
            [](const Approach& a, const Approach& b) { return a.from < b.from; });
  for (std::size_t first = 0; first < approaches.size();) {
    Encroachment stretch;
    stretch.kind = kind;
    stretch.wire = wire.id;
    stretch.span = wire.span;
    stretch.circuit = wire.circuit;
    stretch.other = other;
    stretch.from = approaches[first].from;
    stretch.to = approaches[first].to;
    std::size_t last = first + 1;
    for (; last < approaches.size() && approaches[last].from <= stretch.to + gap;
         ++last)
      stretch.to = std::max(stretch.to, approaches[last].to);
    const std::vector<Approach> places(
        approaches.begin() + static_cast<std::ptrdiff_t>(first),
        approaches.begin() + static_cast<std::ptrdiff_t>(last));
    const Approach& nearest = *std::min_element(
        places.begin(), places.end(), [](const Approach& a, const Approach& b) {
          return a.distance < b.distance;
        });
    stretch.nearest = {nearest.distance, curve.at(nearest.along), nearest.place};
    const Point down = stretch.nearest.wire - stretch.nearest.other;
    stretch.vertical = down.z();
    stretch.horizontal = down.head<2>().norm();
    stretch.severity = limits.severity(kind, nearest.distance);
    stretch.line = lineOf(curve, stretch.from, stretch.to);
    for (std::size_t k = 1; k < stretch.line.size(); ++k)
      stretch.length += (stretch.line[k] - stretch.line[k - 1]).norm();
    stretch.points = places.size();
    stretch.outline = outlineOf(places);
    if (kind == HazardKind::Vegetation)
      measureCut(network, curve, limits.of(kind).low, places, stretch);
    out.push_back(std::move(stretch));
    first = last;
  }
}

} // namespace linelet::powerline
