// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <limits>

#include "world.h"

namespace linelet::bench::scenes {

namespace {

std::uint8_t
classOf(StructureKind kind)
{
  switch (kind) {
  case StructureKind::Pole:
  case StructureKind::Pylon:
    return PylonClass;
  case StructureKind::Insulator:
    return InsulatorClass;
  case StructureKind::Jumper:
    return WireClass;
  case StructureKind::Trunk:
  case StructureKind::Branch:
    return VegetationClass;
  case StructureKind::Aerial:
    return BuildingClass;
  default:
    return OtherClass;
  }
}

} // namespace

void
World::add(StructureKind kind, const Point& from, const Point& to, double radius)
{
  // A rod thinner than the pulse takes its share of it.
  const double cover = std::clamp(1.27 * radius / beam, 0.05, 1.0);
  double reach = radius + 0.8 * beam;
  if (kind == StructureKind::Jumper)
    reach = wire_reach;
  rods.push_back({from, to, radius, reach, cover, classOf(kind)});
  structures.push_back({kind, from, to, radius});
}

bool
World::take(double x, double y, double radius)
{
  for (const Disc& disc : taken)
    if (std::hypot(disc.x - x, disc.y - y) < disc.radius + radius)
      return false;
  taken.push_back({x, y, radius});
  return true;
}

double
World::lowestWire(double x, double y, double reach) const
{
  double lowest = std::numeric_limits<double>::infinity();
  for (const SceneWire& wire : wires)
    for (const Point& p : wire.points)
      if (std::abs(p.x() - x) <= reach && std::hypot(p.x() - x, p.y() - y) <= reach)
        lowest = std::min(lowest, p.z());
  return lowest;
}

} // namespace linelet::bench::scenes
