// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "buildings.h"
#include "recipe.h"

namespace linelet::bench::scenes {

namespace {

/** Where a service drop can end. */
struct Eaves {
  Point place;
};

/** Houses in a row at \a y that face \a side of a street (-1 or 1). */
std::vector<Eaves>
addRow(World& world, double y, double side, Random& random)
{
  std::vector<Eaves> all;
  for (double x = random.uniform(4, 14); x < world.length - 4;
       x += random.uniform(17, 26)) {
    const double at = y + side * random.uniform(0, 3);
    const Point base = world.relief.at(x, at);
    const double side_on = random.integer(0, 1) == 0 ? 0 : pi / 2;
    const double turn = side_on + random.normal(0.05);
    if (!world.take(x, at, 8))
      continue;
    const House house = addHouse(world, Plot(base, turn), random);
    const double wall = side_on == 0 ? house.half_width : house.half_length;
    const double bracket = wall + 0.3; // in front of it, however the house is turned
    all.push_back(
        {base + Point(random.uniform(-2, 2), -side * bracket, house.eaves - 0.2)});
    if (random.integer(0, 1) == 0) {
      const Point front = world.relief.at(x - 9, at - side * 7);
      addFence(world, Plot(front, 0), random.uniform(8, 16), random);
    }
  }
  return all;
}

/** Poles along the street: wires on a crossarm or one below the other, and a telephone
 * cable below. */
LinePlan
streetLine(const World& world, double y, int line, Random& random)
{
  LinePlan plan;
  plan.number = line;
  plan.style = SupportStyle::Wood;
  plan.kind = WireKind::LowVoltage;
  plan.arm_height = random.uniform(7.5, 10);
  plan.insulator = 0;
  plan.clearance = 4.5;
  plan.a = random.uniform(300, 600);
  const int count = random.integer(2, 4);
  const bool rack = random.integer(0, 1) == 0;
  for (int i = 0; i < count; ++i)
    if (rack)
      plan.arms.push_back({0.15, 0.35 * i});
    else
      plan.arms.push_back({1.6 * i / (count - 1) - 0.8, 0});
  if (random.integer(0, 1) == 0)
    plan.arms.push_back({0.15, -random.uniform(1.2, 1.8)});
  const double angle = random.uniform(-0.02, 0.02);
  plan.places =
      linePlaces(world, Point(0, y, 0), angle, random.uniform(32, 48), {}, random);
  return plan;
}

} // namespace

void
addStreet(World& world, double y, int line, bool wires, Random& random)
{
  std::vector<Point> tops;
  const double curb = y + (random.integer(0, 1) == 0 ? -4.5 : 4.5);
  LinePlan plan;
  if (wires) {
    plan = streetLine(world, curb, line, random);
    tops = addLine(world, plan, random);
  }
  std::vector<Eaves> eaves;
  for (const double side : {-1.0, 1.0}) {
    const auto row = addRow(world, y + side * 16, side, random);
    eaves.insert(eaves.end(), row.begin(), row.end());
  }
  int drop = 0;
  for (const Eaves& house : eaves) {
    if (tops.empty() || random.integer(0, 3) == 0)
      continue;
    const auto nearest = *std::min_element(
        tops.begin(), tops.end(), [&](const Point& a, const Point& b) {
          return (a - house.place).squaredNorm() < (b - house.place).squaredNorm();
        });
    const double span = (nearest - house.place).head<2>().norm();
    if (span < 6 || span > 35)
      continue;
    Strung wire;
    wire.kind = WireKind::LowVoltage;
    wire.line = line + 1 + drop++;
    wire.a = random.uniform(100, 300);
    wire.share = random.uniform(0.6, 1);
    addWire(world, wire, nearest - 0.3 * Point::UnitZ(), house.place, random);
  }
  // Street trees stand among the poles and reach the wires.
  for (double x = random.uniform(0, 15); x < world.length; x += random.uniform(9, 30)) {
    const Point base = world.relief.at(x, curb + random.normal(0.7));
    const double height = random.uniform(5, 12);
    const double crown = height * random.uniform(0.2, 0.35);
    if (world.take(base.x(), base.y(), 0.6))
      addTree(world, base, height, crown, TreeStyle::Broadleaf, random);
  }
}

void
addClutter(World& world, Random& random)
{
  // Locations for bulky objects, clear of wires above \a room.
  const auto place = [&](double radius, double room, auto&& put) {
    for (int attempt = 0; attempt < 40; ++attempt) {
      const double x = random.uniform(0.03, 0.97) * world.length;
      const double y = random.uniform(-0.46, 0.46) * world.width;
      const Point p = world.relief.at(x, y);
      if (world.lowestWire(x, y, radius + 3) < p.z() + room ||
          !world.take(x, y, radius))
        continue;
      put(p);
      return;
    }
  };
  const auto turned = [&](const Point& p) {
    return Plot(p, random.uniform(0, 2 * pi));
  };
  const auto along = [&](const Point& p) { // approximately the line's direction
    const double sense = random.integer(0, 1) * pi;
    return Plot(p, sense + random.normal(0.1));
  };
  const int halls = random.integer(1, 3), cranes = random.integer(1, 3);
  const int gantries = random.integer(2, 5), bridges = random.integer(1, 3);
  const int masts = random.integer(1, 2), fences = random.integer(3, 6);
  for (int i = 0; i < bridges; ++i)
    place(2, 12, [&](const Point& p) {
      const Plot plot = along(p);
      addPipeBridge(world, plot, random.uniform(50, 160), random);
    });
  for (int i = 0; i < halls; ++i)
    place(24, 18, [&](const Point& p) { addHall(world, along(p), random); });
  for (int i = 0; i < cranes; ++i)
    place(5, 1e6, [&](const Point& p) {
      const Plot plot = along(p);
      bool clear = true;
      for (double s = -14; s <= 46; s += 4) {
        const Point q = plot.at(s, 0, 0);
        clear = clear && world.lowestWire(q.x(), q.y(), 6) > 1e6;
      }
      if (clear)
        addCrane(world, plot, random);
    });
  for (int i = 0; i < gantries; ++i)
    place(3, 13, [&](const Point& p) { addGantry(world, turned(p), random); });
  for (int i = 0; i < masts; ++i)
    place(3, 60, [&](const Point& p) { addGuyedMast(world, turned(p), random); });
  for (int i = 0; i < fences; ++i)
    place(0.5, 5, [&](const Point& p) {
      const Plot plot = turned(p);
      addFence(world, plot, random.uniform(20, 90), random);
    });
  const double track = random.uniform(-0.4, 0.4) * world.width;
  addTrack(world, Plot(Point(0, track, 0), 0), world.length);
}

} // namespace linelet::bench::scenes
