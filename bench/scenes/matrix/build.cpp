// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>

#include "buildings.h"
#include "recipe.h"

namespace linelet::bench::scenes {

namespace {

/** A line of lattice pylons with six conductors. */
LinePlan
highVoltage(double voltage, int number, Random& random)
{
  LinePlan plan;
  drawTower(plan, voltage, random);
  plan.number = number;
  plan.a = (950 + 1.6 * voltage) * random.uniform(0.9, 1.1);
  plan.hidden = random.uniform(0, 0.06);
  return plan;
}

/** A line of wood poles with three wires on a crossarm. */
LinePlan
mediumVoltage(int number, Random& random)
{
  LinePlan plan;
  plan.number = number;
  plan.style = SupportStyle::Wood;
  plan.kind = WireKind::LowVoltage;
  plan.arm_height = random.uniform(9, 12);
  const double half = random.uniform(0.7, 1.2);
  plan.arms = {{-half, 0}, {0, random.integer(0, 1) * 0.6}, {half, 0}};
  plan.insulator = 0;
  plan.a = random.uniform(450, 900);
  plan.hidden = random.uniform(0, 0.06);
  plan.clearance = 5.5;
  return plan;
}

void
addHouses(World& world, int count, Random& random)
{
  for (int i = 0; i < 20 * count && count > 0; ++i) {
    const double x = random.uniform(0, world.length);
    const double y = random.uniform(-0.5, 0.5) * world.width;
    const Point p = world.relief.at(x, y);
    const double turn = random.uniform(0, pi);
    if (world.lowestWire(x, y, 11) < p.z() + 14 || !world.take(x, y, 10))
      continue;
    addHouse(world, Plot(p, turn), random);
    --count;
  }
}

void
addFences(World& world, int count, Random& random)
{
  for (int i = 0; i < count; ++i) {
    const double x = random.uniform(0, 0.8) * world.length;
    const double y = random.uniform(-0.45, 0.45) * world.width;
    const double turn = random.uniform(0, 2 * pi);
    const double length = random.uniform(20, 80);
    addFence(world, Plot(world.relief.at(x, y), turn), length, random);
  }
}

void
addHedges(World& world, int count, Random& random)
{
  for (int i = 0; i < count; ++i) {
    const double x = random.uniform(0, 0.8) * world.length;
    const double y = random.uniform(-0.45, 0.45) * world.width;
    const double turn = random.uniform(0, 2 * pi);
    const double length = random.uniform(15, 60);
    addHedge(world, Plot(world.relief.at(x, y), turn), length, random);
  }
}

/** A stand of forest on one side, some distance off the line. */
void
addStand(World& world, Random& random)
{
  ForestPlan stand;
  stand.spacing = random.uniform(4.5, 7);
  stand.low = random.uniform(8, 16);
  stand.high = stand.low + random.uniform(3, 10);
  stand.cutting = 2 * random.uniform(0.12, 0.3) * world.width;
  const double share = random.uniform(0.3, 0.8);
  stand.from = random.uniform(0, 1 - share) * world.length;
  stand.to = stand.from + share * world.length;
  stand.side = random.integer(0, 1) * 2 - 1;
  addForest(world, stand, random);
}

/** The line along the extent, as in most scenes. */
void
addMainLine(World& world, LinePlan plan, double span, double bend, Random& random)
{
  const Point through(0, random.uniform(-3, 3), 0);
  const double angle = random.uniform(-1.5, 1.5) * pi / 180;
  plan.places = linePlaces(world, through, angle, span, {0, bend}, random);
  addLine(world, plan, random);
}

void
addFields(World& world, Random& random)
{
  addHouses(world, random.integer(2, 12), random);
  addFences(world, random.integer(1, 3), random);
  addHedges(world, random.integer(1, 3), random);
  // From a few lone trees to connected groves.
  const double trees = 15 * std::exp(random.uniform(0, 2.8));
  const double bushes = random.uniform(10, 120);
  scatterTrees(world, trees, bushes, random);
  if (random.integer(0, 1) == 0)
    addStand(world, random);
}

void
addPoleLineAcross(World& world, int number, Random& random)
{
  LinePlan plan = mediumVoltage(number, random);
  const Point through(random.uniform(0.2, 0.8) * world.length, 0, 0);
  const double angle = random.uniform(60, 120) * pi / 180;
  const double span = random.uniform(34, 60);
  plan.places = linePlaces(world, through, angle, span, {}, random);
  plan.arm_height = random.uniform(7.5, 9.5);
  addLine(world, plan, random);
}

/** Lattice pylons with a slight bend. */
void
addBentLine(World& world, double bend, double low, double high, Random& random)
{
  const double span = random.uniform(low, high);
  addMainLine(world, highVoltage(110, 0, random), span, bend, random);
}

void
buildCorridor(World& world, double bend, Random& random)
{
  addBentLine(world, bend, 200, 330, random);
  addPoleLineAcross(world, 1, random);
  addFields(world, random);
}

void
buildUav(World& world, double bend, Random& random)
{
  const double span = random.uniform(30, 50);
  addMainLine(world, mediumVoltage(0, random), span, bend, random);
  scatterTrees(world, 120, 100, random);
  addFences(world, 1, random);
}

/** A pylon in the middle, with an extent that ends a few meters beyond. */
void
buildStubs(World& world, Random& random)
{
  LinePlan plan = highVoltage(110, 0, random);
  const double before = random.uniform(200, 300), behind = random.uniform(200, 300);
  const int bent = random.integer(0, 1);
  const double bend = bent * random.uniform(0.1, 0.5);
  const double x = 0.5 * world.length;
  plan.places = {Point(x - before, 0, 0),
                 Point(x, 0, 0),
                 Point(x + behind * std::cos(bend), behind * std::sin(bend), 0)};
  addLine(world, plan, random);
  scatterTrees(world, 60, 150, random);
}

void
buildBundles(World& world, int conductors, double low, double high, Random& random)
{
  const double spacing = random.uniform(low, high);
  LinePlan plan = highVoltage(380, 0, random);
  plan.conductors = conductors;
  plan.spacing = spacing;
  const double bend = random.uniform(-0.2, 0.2), span = random.uniform(320, 600);
  addMainLine(world, plan, span, bend, random);
  addFields(world, random);
}

void
buildRiver(World& world, const ReliefPlan& relief, Random& random)
{
  LinePlan plan = highVoltage(220, 0, random);
  plan.a = random.uniform(1700, 2300);
  plan.clearance = 15;
  const double near = relief.river_from - random.uniform(60, 120);
  const double far = relief.river_to + random.uniform(60, 120);
  const double y = random.uniform(-3, 3);
  plan.places = {Point(near - 280, y, 0),
                 Point(near, y, 0),
                 Point(far, y, 0),
                 Point(far + 300, y, 0)};
  addLine(world, plan, random);
  scatterTrees(world, 30, 20, random);
}

/** A cutting hardly wider than its line. */
void
buildForest(World& world, Random& random)
{
  const bool poles = random.integer(0, 2) > 0;
  LinePlan plan = poles ? mediumVoltage(0, random) : highVoltage(110, 0, random);
  plan.hidden = random.uniform(0.15, 0.3);
  const double span = poles ? random.uniform(60, 110) : random.uniform(180, 260);
  addMainLine(world, plan, span, 0, random);
  ForestPlan forest;
  forest.spacing = random.uniform(4.5, 6.5);
  forest.cutting = poles ? random.uniform(3.5, 6) : random.uniform(7, 11);
  forest.overhang = random.uniform(0.5, 0.9);
  forest.high = poles ? 20 : 30;
  addForest(world, forest, random);
}

void
buildCrossings(World& world, Random& random)
{
  const double span = random.uniform(280, 380);
  addMainLine(world, highVoltage(380, 0, random), span, 0, random);
  LinePlan second = highVoltage(110, 1, random);
  const double angle = random.uniform(45, 80) * pi / 180;
  const double second_span = random.uniform(180, 240);
  const Point through(random.uniform(0.3, 0.5) * world.length, 0, 0);
  second.places = linePlaces(world, through, angle, second_span, {}, random);
  second.arm_height = 13;
  addLine(world, second, random);
  addPoleLineAcross(world, 2, random);
  addFields(world, random);
}

void
buildTurns(World& world, Random& random)
{
  LinePlan plan = highVoltage(110, 0, random);
  const double turn = pi / 3 * (random.integer(0, 1) == 0 ? 1 : -1);
  const double span = random.uniform(150, 190);
  const Point through(0, -0.5 * turn * 70, 0);
  plan.places = linePlaces(world, through, 0, span, {turn, -turn, -turn, turn}, random);
  addLine(world, plan, random);
  addFields(world, random);
}

void
buildClutter(World& world, Random& random)
{
  addClutter(world, random);
  addHedges(world, 2, random);
  scatterTrees(world, 20, 20, random);
}

/** Three streets; the outer ones have lines. */
void
buildTown(World& world, bool wires, Random& random)
{
  addStreet(world, -58 + random.uniform(-3, 3), 0, wires, random);
  addStreet(world, random.uniform(-3, 3), 100, false, random);
  addStreet(world, 58 + random.uniform(-3, 3), 200, wires, random);
  scatterTrees(world, 25, 15, random);
}

} // namespace

std::vector<Point>
linePlaces(const World& world,
           const Point& through,
           double angle,
           double span,
           const std::vector<double>& bends,
           Random& random)
{
  // Back to one span before the extent, then on to one beyond it.
  const double reach = std::abs(std::cos(angle)) * through.x() +
                       std::abs(std::sin(angle)) * 0.5 * world.width;
  const double total = std::abs(std::cos(angle)) * world.length +
                       std::abs(std::sin(angle)) * world.width;
  const Point start = through - (reach + span * random.uniform(0.2, 0.9)) *
                                    Point(std::cos(angle), std::sin(angle), 0);
  std::vector<Point> places{start};
  double direction = angle, run = 0;
  for (std::size_t i = 0; run < total + 1.2 * span; ++i) {
    if (i > 0 && i <= bends.size())
      direction += bends[i - 1];
    const double step = span * random.uniform(0.85, 1.15);
    places.push_back(places.back() +
                     step * Point(std::cos(direction), std::sin(direction), 0));
    run += step;
  }
  return places;
}

void
build(World& world, SceneKind kind, const Recipe& recipe, Random& random)
{
  const double bend = random.uniform(-0.15, 0.15); // radians
  switch (kind) {
  case SceneKind::Standard:
  case SceneKind::Sparse:
  case SceneKind::Strips:
  case SceneKind::WideBeam:
    return buildCorridor(world, bend, random);
  case SceneKind::Helicopter:
    addBentLine(world, bend, 150, 220, random);
    return addFields(world, random);
  case SceneKind::Uav:
    return buildUav(world, bend, random);
  case SceneKind::Stubs:
    return buildStubs(world, random);
  case SceneKind::Twin:
    return buildBundles(world, 2, 0.38, 0.5, random);
  case SceneKind::Triple:
    return buildBundles(world, 3, 0.38, 0.5, random);
  case SceneKind::Quad:
    return buildBundles(world, 4, 0.4, 0.5, random);
  case SceneKind::River:
    return buildRiver(world, recipe.relief, random);
  case SceneKind::Mountain:
    addBentLine(world, bend, 180, 360, random);
    return scatterTrees(world, random.uniform(5, 60), 10, random);
  case SceneKind::MountainEmpty:
    return scatterTrees(world, random.uniform(0, 20), 5, random);
  case SceneKind::Street:
    addStreet(world, random.uniform(-4, 4), 0, true, random);
    return scatterTrees(world, 70, 30, random);
  case SceneKind::Forest:
    return buildForest(world, random);
  case SceneKind::ForestEmpty: {
    ForestPlan forest;
    forest.spacing = random.uniform(4.5, 7);
    forest.cutting = random.integer(0, 1) * 8.0;
    return addForest(world, forest, random);
  }
  case SceneKind::Crossings:
    return buildCrossings(world, random);
  case SceneKind::Turns:
    return buildTurns(world, random);
  case SceneKind::Clutter:
    addBentLine(world, bend, 180, 280, random);
    return buildClutter(world, random);
  case SceneKind::ClutterEmpty:
    return buildClutter(world, random);
  case SceneKind::Town:
    return buildTown(world, true, random);
  case SceneKind::TownEmpty:
    return buildTown(world, false, random);
  }
}

} // namespace linelet::bench::scenes
