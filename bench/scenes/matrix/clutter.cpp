// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "buildings.h"
#include "lines.h"

namespace linelet::bench::scenes {

namespace {

/** Square lattice boom of half width \a half from one end to the other. */
void
addBoom(World& world,
        StructureKind kind,
        const Point& from,
        const Point& to,
        double half,
        double pitch)
{
  const Point along = (to - from).normalized();
  const Point side = std::abs(along.z()) > 0.9
                         ? Point(Point::UnitX())
                         : Point(along.cross(Point::UnitZ()).normalized());
  const Point up = side.cross(along);
  Point bottom[4], top[4];
  const double sign[4][2] = {{1, 1}, {1, -1}, {-1, -1}, {-1, 1}};
  for (int i = 0; i < 4; ++i) {
    const Point off = half * (sign[i][0] * side + sign[i][1] * up);
    bottom[i] = from + off;
    top[i] = to + off;
  }
  const int bays = std::max(1, static_cast<int>((to - from).norm() / pitch));
  addLattice(world, kind, bottom, top, bays, 0.08);
}

Point
onGround(const World& world, const Point& p)
{
  return world.relief.at(p.x(), p.y());
}

} // namespace

void
addCrane(World& world, const Plot& plot, Random& random)
{
  const double height = random.uniform(24, 45), jib = random.uniform(22, 45);
  const auto kind = StructureKind::Crane;
  const Point top = plot.at(0, 0, height), head = plot.at(0, 0, height + 5);
  const Point tip = plot.at(jib, 0, height), back = plot.at(-0.3 * jib, 0, height);
  addBoom(world, kind, plot.base, top, 0.8, 2);
  addBoom(world, kind, top, tip, 0.5, 2);
  addBoom(world, kind, top, back, 0.5, 2);
  world.add(kind, top, head, 0.15);
  world.add(kind, head, plot.at(0.7 * jib, 0, height), 0.03);
  world.add(kind, head, back, 0.03);
  world.add(kind, back, back - 2 * Point::UnitZ(), 0.9); // counterweight
  const Point trolley = plot.at(random.uniform(0.3, 0.9) * jib, 0, height);
  world.add(
      kind, trolley, trolley - random.uniform(5, height - 5) * Point::UnitZ(), 0.02);
}

void
addGantry(World& world, const Plot& plot, Random& random)
{
  const double width = random.uniform(14, 40), height = random.uniform(6, 9);
  const auto kind = StructureKind::Gantry;
  const Point left = plot.at(-0.5 * width, 0, 0), right = plot.at(0.5 * width, 0, 0);
  const Point up = (plot.base.z() + height) * Point::UnitZ();
  const Point left_top = Point(left.x(), left.y(), 0) + up;
  const Point right_top = Point(right.x(), right.y(), 0) + up;
  world.add(kind, onGround(world, left), left_top, 0.2);
  world.add(kind, onGround(world, right), right_top, 0.2);
  if (random.integer(0, 1) == 0)
    addBoom(world, kind, left_top, right_top, 0.4, 1.2);
  else
    world.add(kind, left_top, right_top, 0.2);
}

void
addPipeBridge(World& world, const Plot& plot, double length, Random& random)
{
  const auto kind = StructureKind::Pipe;
  const double height = random.uniform(4.5, 8), pitch = random.uniform(6, 15);
  const int pipes = random.integer(2, 5);
  double across = 0;
  double low = plot.base.z(); // pipes run level, above the highest ground
  for (double s = 0; s <= length; s += 5)
    low = std::max(low, onGround(world, plot.at(s, 0, 0)).z());
  const double z = low + height - plot.base.z();
  for (int i = 0; i < pipes; ++i) {
    const double radius = random.uniform(0.05, 0.3);
    across += radius + 0.15;
    world.add(kind,
              plot.at(0, across, z + radius),
              plot.at(length, across, z + radius),
              radius);
    across += radius;
  }
  for (double s = 0.3 * pitch; s < length; s += pitch) {
    world.add(
        StructureKind::Gantry, plot.at(s, -0.2, z), plot.at(s, across + 0.2, z), 0.12);
    for (const double side : {0.0, across}) {
      const Point top = plot.at(s, side, z);
      world.add(StructureKind::Gantry, onGround(world, top), top, 0.1);
    }
  }
}

void
addGuyedMast(World& world, const Plot& plot, Random& random)
{
  const double height = random.uniform(20, 45),
               reach = height * random.uniform(0.4, 0.7);
  addBoom(world, StructureKind::Crane, plot.base, plot.at(0, 0, height), 0.25, 1);
  for (const double level : {0.55, 0.95})
    for (int i = 0; i < 3; ++i) {
      const double angle = 2 * pi * i / 3;
      const Point foot = plot.at(reach * std::cos(angle), reach * std::sin(angle), 0);
      world.add(StructureKind::Guy,
                plot.at(0, 0, level * height),
                onGround(world, foot),
                0.01);
    }
}

void
addFence(World& world, const Plot& plot, double length, Random& random)
{
  const bool railing = random.integer(0, 1) == 0;
  const double height = railing ? 1.1 : random.uniform(1.2, 2.2);
  Point last[3];
  for (double s = 0; s <= length; s += 2.5) {
    const Point foot = onGround(world, plot.at(s, 0, 0));
    world.add(StructureKind::Fence, foot, foot + height * Point::UnitZ(), 0.05);
    for (int rail = 0; rail < 3; ++rail) {
      const Point at = foot + (1 - 0.35 * rail) * height * Point::UnitZ();
      if (s > 0)
        world.add(StructureKind::Fence, last[rail], at, railing ? 0.025 : 0.005);
      last[rail] = at;
    }
  }
}

void
addTrack(World& world, const Plot& plot, double length)
{
  constexpr double gauge = 1.5, rail = 0.17; // between rail heads; height of a rail
  for (const double side : {-0.5 * gauge, 0.5 * gauge})
    for (double s = 0; s + 5 <= length; s += 5)
      world.add(StructureKind::Rail,
                onGround(world, plot.at(s, side, 0)) + rail * Point::UnitZ(),
                onGround(world, plot.at(s + 5, side, 0)) + rail * Point::UnitZ(),
                0.04);
}

} // namespace linelet::bench::scenes
