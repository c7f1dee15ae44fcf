// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "wires.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Geometry>

namespace linelet::bench::scenes {

namespace {

constexpr double wire_cover = 0.3; ///< share of a pulse's energy that a wire takes
constexpr double chance = 0.6;     ///< probability that a wire in reach answers a pulse

/** Positions of the conductors of a bundle in the plane across it: a regular polygon
 * with sides of \a spacing. */
std::vector<std::pair<double, double>>
bundleOffsets(int conductors, double spacing)
{
  std::vector<std::pair<double, double>> offsets;
  if (conductors == 1)
    return {{0, 0}};
  const double radius = 0.5 * spacing / std::sin(pi / conductors);
  // Twins lie side by side, a triangle stands on a side, four form an upright square.
  const double turn = conductors == 2 ? 0 : (conductors == 3 ? pi / 2 : pi / 4);
  for (int i = 0; i < conductors; ++i) {
    const double angle = turn + 2 * pi * i / conductors;
    offsets.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return offsets;
}

/** Stretches without returns, as shares of the wire. */
std::vector<std::pair<double, double>>
drawHidden(double share, double length, Random& random)
{
  std::vector<std::pair<double, double>> stretches;
  double hidden = 0;
  while (hidden < share * length) {
    const double extent = std::min(random.uniform(3, 22), share * length - hidden + 1);
    const double from = random.uniform(0, std::max(0.0, length - extent));
    stretches.emplace_back(from / length, (from + extent) / length);
    hidden += extent;
  }
  return stretches;
}

} // namespace

Point
hangingPoint(const Point& from, const Point& to, double a, double share)
{
  const double span = std::hypot(to.x() - from.x(), to.y() - from.y());
  const double rise = to.z() - from.z();
  // The lowest point: the sinh of the middle follows from the rise.
  const double middle = a * std::asinh(rise / (2 * a * std::sinh(span / (2 * a))));
  const double lowest = 0.5 * span - middle;
  Point p = from + share * (to - from);
  p.z() =
      from.z() + a * (std::cosh((share * span - lowest) / a) - std::cosh(lowest / a));
  return p;
}

void
addWire(World& world,
        const Strung& strung,
        const Point& from,
        const Point& to,
        Random& random)
{
  const double span = std::hypot(to.x() - from.x(), to.y() - from.y());
  const Point right((to.y() - from.y()) / span, (from.x() - to.x()) / span, 0);
  const auto at = [&](double s) { return hangingPoint(from, to, strung.a, s / span); };

  SceneWire wire;
  wire.kind = strung.kind;
  wire.line = strung.line;
  wire.span = strung.span;
  wire.number = strung.number;
  wire.conductors = strung.conductors;
  const auto offsets = bundleOffsets(strung.conductors, strung.spacing);
  wire.bundle_radius = std::hypot(offsets[0].first, offsets[0].second);
  const int pieces = std::max(8, static_cast<int>(std::ceil(span / 2)));
  for (int i = 0; i <= pieces; ++i)
    wire.points.push_back(at(span * i / pieces));

  const auto index = static_cast<std::int32_t>(world.wires.size());
  // Four form two columns, and a pulse sees either the upper or the lower one of a
  // column.
  const bool square = strung.conductors == 4;
  const double answers =
      square ? 2 * (1 - (1 - chance) * (1 - chance)) : strung.conductors * chance;
  const double narrow = world.wire_reach * strung.share / answers;
  const double reach = world.aside ? world.beam : narrow;
  const auto hidden = drawHidden(strung.hidden, span, random);
  const auto seed = static_cast<std::uint32_t>(random.integer(0, 1 << 30));
  const double back = span - strung.back_string;
  for (int i = 0; i < pieces; ++i) {
    const double s0 = span * i / pieces, s1 = span * (i + 1) / pieces;
    const double w0 = std::clamp(strung.front_string, s0, s1),
                 w1 = std::clamp(back, s0, s1);
    if (s0 < w0)
      world.add(StructureKind::Insulator, at(s0), at(w0), 0.1);
    if (w1 < s1)
      world.add(StructureKind::Insulator, at(w1), at(s1), 0.1);
    const double middle = 0.5 * (w0 + w1) / span;
    // Returns come and go along a wire over some meters.
    const double fading = 0.5 + smoothNoise(Point(middle * span / 8, 0, 0), seed);
    const bool seen =
        std::none_of(hidden.begin(), hidden.end(), [&](const auto& stretch) {
          return middle > stretch.first && middle < stretch.second;
        });
    if (w0 < w1 && seen)
      for (const auto& [aside, above] : offsets) {
        const Point off = aside * right + above * Point::UnitZ();
        world.rods.push_back({at(w0) + off,
                              at(w1) + off,
                              0.0135,
                              reach,
                              wire_cover,
                              WireClass,
                              index,
                              chance * fading * (narrow / reach),
                              world.aside});
      }
  }
  world.wires.push_back(std::move(wire));
}

} // namespace linelet::bench::scenes
