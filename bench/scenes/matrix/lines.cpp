// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Geometry>

#include "lines.h"

namespace linelet::bench::scenes {

namespace {

/** A tower or pole of a line. */
struct Support {
  Point base;
  Point along, across;
  double lift = 0;      ///< above the plan's height
  bool tension = false; ///< strings in the direction of the wires
};

std::vector<Support>
placeSupports(const World& world, const LinePlan& plan)
{
  std::vector<Support> all;
  const std::size_t n = plan.places.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Point& here = plan.places[i];
    const Point before = i > 0 ? here - plan.places[i - 1] : plan.places[1] - here;
    const Point behind = i + 1 < n ? plan.places[i + 1] - here : before;
    const Point one(before.x(), before.y(), 0), two(behind.x(), behind.y(), 0);
    Support s;
    s.base = world.relief.at(here.x(), here.y());
    s.along = (one.normalized() + two.normalized()).normalized();
    s.across = Point(-s.along.y(), s.along.x(), 0);
    s.tension = one.normalized().dot(two.normalized()) < 0.998; // 4 degrees
    all.push_back(s);
  }
  return all;
}

Point
attachment(const LinePlan& plan, const Support& s, const Arm& arm, bool hangs)
{
  const double drop = hangs && !s.tension ? plan.insulator : 0;
  return s.base + arm.offset * s.across +
         (plan.arm_height + s.lift + arm.height - drop) * Point::UnitZ();
}

/** Raises supports until every conductor is clear of the ground. */
void
liftSupports(const World& world, const LinePlan& plan, std::vector<Support>& supports)
{
  for (int round = 0; round < 4; ++round)
    for (std::size_t i = 0; i + 1 < supports.size(); ++i) {
      double deficit = 0;
      for (const Arm& arm : plan.arms) {
        const Point from = attachment(plan, supports[i], arm, true);
        const Point to = attachment(plan, supports[i + 1], arm, true);
        for (int k = 1; k < 40; ++k) {
          const Point p = hangingPoint(from, to, plan.a, k / 40.0);
          const double room = p.z() - world.relief.height(p.x(), p.y());
          deficit = std::max(deficit, plan.clearance - room);
        }
      }
      supports[i].lift += 0.7 * deficit;
      supports[i + 1].lift += 0.7 * deficit;
    }
}

/** The corners of a square of half width \a half around a support's axis. */
void
square(const Support& s, double height, double half, Point (&corners)[4])
{
  const double side[4][2] = {{1, 1}, {1, -1}, {-1, -1}, {-1, 1}};
  for (int i = 0; i < 4; ++i)
    corners[i] = s.base + half * side[i][0] * s.along + half * side[i][1] * s.across +
                 height * Point::UnitZ();
}

void
addArm(World& world, const LinePlan& plan, const Support& s, const Arm& arm)
{
  const double f = plan.scale, z = plan.arm_height + s.lift + arm.height;
  const double side = arm.offset < 0 ? -1 : 1, waist = 0.75 * f;
  const Point tip = s.base + arm.offset * s.across + z * Point::UnitZ();
  const Point root = s.base + side * 0.5 * waist * s.across;
  const Point low[2] = {root + 0.5 * waist * s.along + z * Point::UnitZ(),
                        root - 0.5 * waist * s.along + z * Point::UnitZ()};
  const Point high = root + (z + 1.3 * f) * Point::UnitZ();
  const auto beam = [&](const Point& from, const Point& to, double radius) {
    world.add(StructureKind::Pylon, from, to, radius * f);
  };
  beam(low[0], tip, 0.05);
  beam(low[1], tip, 0.05);
  beam(high, tip, 0.05);
  const int bays = std::max(2, static_cast<int>(std::abs(arm.offset) / 1.2));
  for (int i = 0; i < bays; ++i) {
    const double t = static_cast<double>(i) / bays, u = (i + 0.5) / bays;
    const Point on_high = high + u * (tip - high);
    for (const Point& corner : low) {
      beam(corner + t * (tip - corner), on_high, 0.03);
      beam(on_high, corner + (t + 1.0 / bays) * (tip - corner), 0.03);
    }
  }
  if (!s.tension && plan.insulator > 0)
    world.add(
        StructureKind::Insulator, tip, tip - plan.insulator * Point::UnitZ(), 0.1);
}

void
addLatticeTower(World& world, const LinePlan& plan, const Support& s)
{
  const double f = plan.scale, arm = plan.arm_height + s.lift;
  const double peak = arm + plan.peak;
  Point bottom[4], middle[4], top[4];
  square(s, 0, 0.09 * arm + 1.1 * f, bottom);
  square(s, arm, 0.75 * f, middle);
  square(s, peak, 0.12 * f, top);
  addLattice(world,
             StructureKind::Pylon,
             bottom,
             middle,
             std::max(5, static_cast<int>(arm / 4)),
             0.06 * f);
  addLattice(world,
             StructureKind::Pylon,
             middle,
             top,
             std::max(2, static_cast<int>(plan.peak / 1.6)),
             0.05 * f);
  for (const Arm& a : plan.arms)
    addArm(world, plan, s, a);
  if (plan.earth_wires == 2)
    for (const double side : {-1.0, 1.0})
      world.add(StructureKind::Pylon,
                s.base + (peak - 1.5 * f) * Point::UnitZ(),
                s.base + side * 2 * f * s.across + peak * Point::UnitZ(),
                0.05 * f);
  world.taken.push_back({s.base.x(), s.base.y(), 0.12 * arm + 3});
}

void
addWoodPole(World& world, const LinePlan& plan, const Support& s)
{
  const double arm = plan.arm_height + s.lift;
  double top = 0;
  std::vector<double> levels;
  for (const Arm& a : plan.arms) {
    top = std::max(top, a.height);
    if (std::find(levels.begin(), levels.end(), a.height) == levels.end())
      levels.push_back(a.height);
  }
  world.add(
      StructureKind::Pole, s.base, s.base + (arm + top + 0.3) * Point::UnitZ(), 0.14);
  for (const double level : levels) {
    double left = 0, right = 0;
    for (const Arm& a : plan.arms)
      if (a.height == level) {
        left = std::min(left, a.offset);
        right = std::max(right, a.offset);
      }
    if (right - left > 0.3) {
      const Point on = s.base + (arm + level - 0.15) * Point::UnitZ();
      world.add(StructureKind::Pole,
                on + (left - 0.1) * s.across,
                on + (right + 0.1) * s.across,
                0.06);
    }
  }
  world.taken.push_back({s.base.x(), s.base.y(), 1});
}

/** The loop around a tension pylon, below the crossarm. */
void
addJumper(World& world,
          const Point& tip,
          const Point& before,
          const Point& behind,
          double string)
{
  Point last = tip + string * before;
  for (int k = 1; k <= 10; ++k) {
    const double t = k / 10.0;
    const Point next = tip + string * ((1 - t) * before + t * behind) -
                       string * 0.9 * 4 * t * (1 - t) * Point::UnitZ();
    world.add(StructureKind::Jumper, last, next, 0.0135);
    last = next;
  }
}

void
string(World& world,
       const LinePlan& plan,
       const std::vector<Support>& supports,
       const Arm& arm,
       Strung wire,
       Random& random)
{
  const bool hangs = wire.kind == WireKind::Conductor && plan.insulator > 0;
  for (std::size_t i = 0; i + 1 < supports.size(); ++i) {
    const Point from = attachment(plan, supports[i], arm, hangs);
    const Point to = attachment(plan, supports[i + 1], arm, hangs);
    wire.span = static_cast<int>(i);
    wire.front_string = hangs && supports[i].tension ? plan.insulator : 0;
    wire.back_string = hangs && supports[i + 1].tension ? plan.insulator : 0;
    addWire(world, wire, from, to, random);
    if (hangs && i > 0 && supports[i].tension) {
      const Point before = attachment(plan, supports[i - 1], arm, hangs) - from;
      addJumper(
          world, from, before.normalized(), (to - from).normalized(), plan.insulator);
    }
  }
}

} // namespace

void
drawTower(LinePlan& plan, double voltage, Random& random)
{
  plan.scale = std::clamp(0.73 + voltage / 400, 0.85, 1.75);
  const double f = plan.scale;
  plan.arm_height = 20 * f;
  plan.insulator = std::clamp(voltage / 100, 0.9, 3.8) + 0.4;
  plan.earth_wires = random.integer(1, 2);
  const auto pair = [&](double offset, double height) {
    plan.arms.push_back({-offset * f, height * f});
    plan.arms.push_back({offset * f, height * f});
  };
  const int type = random.integer(0, 2);
  if (type == 0) {
    pair(3.0, 0);
    pair(6.0, 0);
    pair(4.3, 4.4);
    plan.peak = 9 * f;
  }
  else if (type == 1) {
    pair(3.4, 0);
    pair(4.8, 4.2);
    pair(3.4, 8.4);
    plan.peak = 12.6 * f;
  }
  else {
    pair(2.7, 0);
    pair(5.4, 0);
    pair(8.1, 0);
    plan.peak = 5 * f;
  }
}

std::vector<Point>
addLine(World& world, const LinePlan& plan, Random& random)
{
  std::vector<Support> supports = placeSupports(world, plan);
  if (plan.style == SupportStyle::Lattice)
    for (Support& s : supports)
      s.lift = random.uniform(-1.5, 3);
  else
    for (Support& s : supports)
      s.lift = random.uniform(-0.4, 0.6);
  liftSupports(world, plan, supports);
  std::vector<Point> tops;
  for (const Support& s : supports) {
    if (plan.style == SupportStyle::Lattice)
      addLatticeTower(world, plan, s);
    else
      addWoodPole(world, plan, s);
    tops.push_back(s.base + (plan.arm_height + s.lift) * Point::UnitZ());
  }
  Strung wire;
  wire.line = plan.number;
  wire.kind = plan.kind;
  wire.conductors = plan.conductors;
  wire.spacing = plan.spacing;
  wire.hidden = plan.hidden;
  for (const Arm& arm : plan.arms) {
    ++wire.number;
    wire.a = plan.a * random.uniform(0.985, 1.015);
    string(world, plan, supports, arm, wire, random);
  }
  if (plan.style == SupportStyle::Wood)
    return tops;
  wire.kind = WireKind::Earth;
  wire.conductors = 1;
  wire.share = 0.7;
  for (int i = 0; i < plan.earth_wires; ++i) {
    const double offset =
        plan.earth_wires == 1 ? 0 : (i == 0 ? -2.0 : 2.0) * plan.scale;
    ++wire.number;
    wire.a = 1.2 * plan.a * random.uniform(0.985, 1.015);
    string(world, plan, supports, {offset, plan.peak}, wire, random);
  }
  return tops;
}

} // namespace linelet::bench::scenes
