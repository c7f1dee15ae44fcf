// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>

#include "trees.h"

namespace linelet::bench::scenes {

namespace {

/** A branch in two pieces that bends upward. */
void
addBranch(World& world,
          const Point& from,
          double direction,
          double reach,
          double rise,
          Random& random)
{
  const Point out(std::cos(direction), std::sin(direction), 0);
  const double radius = 0.008 * reach + 0.015;
  const Point elbow = from + 0.5 * reach * out + 0.35 * rise * Point::UnitZ();
  const double turn = random.uniform(-0.4, 0.4);
  const Point on(std::cos(direction + turn), std::sin(direction + turn), 0);
  const Point tip = elbow + 0.5 * reach * on + 0.65 * rise * Point::UnitZ();
  world.add(StructureKind::Branch, from, elbow, radius);
  world.add(StructureKind::Branch, elbow, tip, 0.6 * radius);
}

void
addBroadleaf(
    World& world, const Point& base, double height, double crown, Random& random)
{
  const double bare = height * random.uniform(0.15, 0.35);
  const int branches = random.integer(5, 10);
  for (int i = 0; i < branches; ++i) {
    const double t = random.uniform(0, 0.75);
    const double direction = random.uniform(0, 2 * pi);
    const double reach = crown * random.uniform(0.6, 0.95) * (1 - 0.5 * t);
    const double rise = reach * random.uniform(0.3, 1);
    addBranch(world,
              base + (bare + t * (height - bare)) * Point::UnitZ(),
              direction,
              reach,
              rise,
              random);
  }
  // Lobes around a main crown.
  const double middle = 0.5 * (bare + height), half = 0.5 * (height - bare);
  world.crowns.push_back({base + middle * Point::UnitZ(),
                          Point(0.85 * crown, 0.85 * crown, half),
                          random.uniform(0.8, 1.7)});
  const int lobes = random.integer(2, 5);
  for (int i = 0; i < lobes; ++i) {
    const double direction = random.uniform(0, 2 * pi),
                 r = crown * random.uniform(0.4, 0.6);
    const double z = middle + half * random.uniform(-0.5, 0.5);
    const double aside = crown - r;
    world.crowns.push_back(
        {base + Point(aside * std::cos(direction), aside * std::sin(direction), z),
         Point(r, r, std::min(r, height - z)),
         random.uniform(0.8, 1.7)});
  }
}

void
addConifer(World& world, const Point& base, double height, double crown, Random& random)
{
  const double bare = height * random.uniform(0.08, 0.3);
  constexpr int levels = 5;
  for (int i = 0; i < levels; ++i) {
    const double t = (i + 0.5) / levels, tall = (height - bare) / levels;
    const double r = crown * (1.1 - t);
    const double z = bare + t * (height - bare);
    world.crowns.push_back({base + z * Point::UnitZ(),
                            Point(r, r, 0.75 * tall),
                            random.uniform(0.7, 1.3)});
    for (int k = 0; k < 2; ++k) {
      const double direction = random.uniform(0, 2 * pi);
      addBranch(
          world, base + z * Point::UnitZ(), direction, 0.9 * r, -0.15 * r, random);
    }
  }
}

} // namespace

void
addTree(World& world,
        const Point& base,
        double height,
        double crown_radius,
        TreeStyle style,
        Random& random)
{
  const double lean_y = random.normal(0.02), lean_x = random.normal(0.02);
  const Point lean(lean_x, lean_y, 1);
  world.add(
      StructureKind::Trunk, base, base + 0.85 * height * lean, 0.009 * height + 0.03);
  if (style == TreeStyle::Conifer)
    addConifer(world, base, height, crown_radius, random);
  else
    addBroadleaf(world, base, height, crown_radius, random);
}

void
addBush(World& world, const Point& base, Random& random)
{
  const double r = random.uniform(0.5, 1.8), tall = random.uniform(0.4, 1.4);
  world.crowns.push_back({base + 0.6 * tall * Point::UnitZ(),
                          Point(r, r, tall),
                          random.uniform(0.3, 0.8)});
}

void
addHedge(World& world, const Plot& plot, double length, Random& random)
{
  const double tall = random.uniform(0.8, 2.2), wide = random.uniform(0.4, 0.8);
  for (double s = 0; s < length; s += 0.9 * wide) {
    const Point foot = plot.at(s, random.normal(0.1), 0);
    const Point base = world.relief.at(foot.x(), foot.y());
    world.crowns.push_back({base + 0.5 * tall * Point::UnitZ(),
                            Point(wide, wide, 0.6 * tall),
                            random.uniform(0.3, 0.6)});
  }
}

void
addForest(World& world, const ForestPlan& plan, Random& random)
{
  const double half = 0.5 * world.width + 5;
  const auto style_of = [&] {
    return random.integer(0, 2) == 0 ? TreeStyle::Conifer : TreeStyle::Broadleaf;
  };
  for (double gx = -5; gx < world.length + 5; gx += plan.spacing)
    for (double gy = -half; gy < half; gy += plan.spacing) {
      const double x = gx + random.uniform(0, plan.spacing);
      const double y = gy + random.uniform(0, plan.spacing);
      const double height = random.uniform(plan.low, plan.high);
      const double crown = plan.spacing * random.uniform(0.5, 0.8);
      const TreeStyle style = style_of();
      const double room = std::abs(y) - 0.5 * plan.cutting;
      if (room < 0 || x < plan.from || x > plan.to || y * plan.side < 0)
        continue;
      Point base = world.relief.at(x, y);
      // Trees at the border lean over the cutting; otherwise their crowns would stop
      // there.
      if (room < plan.spacing && random.uniform(0, 1) < plan.overhang)
        base.y() -= std::copysign(std::min(0.45 * plan.cutting, 0.8 * plan.spacing), y);
      else if (room < crown && plan.cutting > 0)
        base.y() += std::copysign(crown - room, y);
      bool free = true;
      for (const Disc& disc : world.taken)
        free = free && std::hypot(disc.x - base.x(), disc.y - base.y()) > disc.radius;
      if (!free)
        continue;
      addTree(world, base, height, crown, style, random);
      if (random.uniform(0, 1) < plan.understory) {
        const double bx = x + random.normal(2), by = y + random.normal(2);
        addBush(world, world.relief.at(bx, by), random);
      }
    }
}

void
scatterTrees(World& world,
             double per_hectare,
             double bushes_per_hectare,
             Random& random)
{
  const double hectares = world.length * world.width / 1e4, half = 0.5 * world.width;
  const auto anywhere = [&]() -> Point {
    const double x = random.uniform(0, world.length);
    const double y = random.uniform(-half, half);
    return world.relief.at(x, y);
  };
  Point last = anywhere();
  for (int i = 0; i < static_cast<int>(per_hectare * hectares); ++i) {
    Point p = anywhere();
    // Every other one is close to the previous one: groves, rows and lone trees.
    if (random.integer(0, 1) == 0) {
      const double x = last.x() + random.normal(5), y = last.y() + random.normal(5);
      p = world.relief.at(x, y);
    }
    last = p;
    double height = random.uniform(5, 22);
    const double gap = random.uniform(0.5, 8);
    height = std::min(height,
                      world.lowestWire(p.x(), p.y(), 0.25 * height + 3) - p.z() - gap);
    const double crown = height * random.uniform(0.17, 0.3);
    const TreeStyle style =
        random.integer(0, 2) == 0 ? TreeStyle::Conifer : TreeStyle::Broadleaf;
    if (height >= 3 && !world.relief.water(p.x(), p.y()) &&
        world.take(p.x(), p.y(), 0.08 * height))
      addTree(world, p, height, crown, style, random);
  }
  for (int i = 0; i < static_cast<int>(bushes_per_hectare * hectares); ++i) {
    const Point p = anywhere();
    if (!world.relief.water(p.x(), p.y()) && world.take(p.x(), p.y(), 0.5))
      addBush(world, p, random);
  }
}

} // namespace linelet::bench::scenes
