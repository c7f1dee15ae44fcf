// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "corridor_members.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <bench/scenes/lattice.h>

namespace linelet::bench::corridor {

void
addWire(Scene& scene,
        CorridorWire wire,
        const Point& from,
        const Point& to,
        const WireParameters& parameters)
{
  const double a = parameters.a;
  const double span = std::hypot(to.x() - from.x(), to.y() - from.y());
  const double rise = to.z() - from.z();
  // The lowest point: the sinh of the middle follows from the rise.
  const double middle = a * std::asinh(rise / (2 * a * std::sinh(span / (2 * a))));
  const double lowest = 0.5 * span - middle;
  const double phi = parameters.wind * pi / 180;
  const Point right((to.y() - from.y()) / span, (from.x() - to.x()) / span, 0);
  const auto at = [&](double s) -> Point {
    const double t = s / span;
    const double z = a * (std::cosh((s - lowest) / a) - std::cosh(lowest / a));
    const double sag = rise * t - z;
    return from + t * (to - from) - sag * std::cos(phi) * Point::UnitZ() +
           sag * std::sin(phi) * right;
  };

  const int pieces = std::max(8, static_cast<int>(std::ceil(span / 2)));
  wire.points.push_back(from);
  for (int i = 1; i < pieces; ++i)
    wire.points.push_back(at(span * i / pieces));
  wire.points.push_back(to);

  const auto index = static_cast<std::int32_t>(scene.wires.size());
  const double strings[2] = {parameters.front_string, span - parameters.back_string};
  for (int i = 0; i < pieces; ++i) {
    // Insulators take up the first and last meters at a tension pylon.
    const double s0 = span * i / pieces, s1 = span * (i + 1) / pieces;
    const double w0 = std::clamp(strings[0], s0, s1),
                 w1 = std::clamp(strings[1], s0, s1);
    if (s0 < w0)
      scene.beam(at(s0), at(w0), 0.08, PylonClass, 0.4);
    if (w1 < s1)
      scene.beam(at(w1), at(s1), 0.08, PylonClass, 0.4);
    if (w0 < w1)
      scene.members.push_back(
          {at(w0), at(w1), parameters.radius, WireClass, 0.45F, index});
  }
  wire.front_attached = wire.back_attached = true;
  scene.wires.push_back(std::move(wire));
}

void
addLattice(Scene& scene,
           const Point (&bottom)[4],
           const Point (&top)[4],
           int bays,
           double radius,
           std::uint8_t classification)
{
  forEachLatticeBar(
      bottom, top, bays, [&](const Point& from, const Point& to, double share) {
        scene.beam(from, to, share * radius, classification, 0.5);
      });
}

void
addGaps(Scene& scene, double per_kilometer, Random& random)
{
  std::vector<std::vector<std::pair<Point, double>>> gaps(scene.wires.size());
  for (std::size_t w = 0; w < scene.wires.size(); ++w) {
    const Points& points = scene.wires[w].points;
    const double length = (points.back() - points.front()).norm();
    const double mean = per_kilometer * length / 1000;
    // The integer part for certain, the rest by chance.
    int count = static_cast<int>(mean);
    if (random.uniform(0, 1) < mean - count)
      ++count;
    for (int i = 0; i < count; ++i) {
      const int middle = random.integer(1, static_cast<int>(points.size()) - 2);
      gaps[w].emplace_back(points[static_cast<std::size_t>(middle)],
                           random.uniform(1.5, 5));
    }
  }
  const auto silent = [&](const Member& member) {
    if (member.wire < 0)
      return false;
    const Point middle = 0.5 * (member.from + member.to);
    for (const auto& [center, half] : gaps[static_cast<std::size_t>(member.wire)])
      if ((middle - center).norm() < half)
        return true;
    return false;
  };
  scene.members.erase(
      std::remove_if(scene.members.begin(), scene.members.end(), silent),
      scene.members.end());
}

} // namespace linelet::bench::corridor
