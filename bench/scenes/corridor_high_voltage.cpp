// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "corridor_high_voltage.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "corridor_members.h"

namespace linelet::bench::corridor {

namespace {

/** A place on a crossarm where a conductor is attached. */
struct Arm {
  double offset, height;
};

/** Pylon of a voltage: heights above its lowest arm's conductors at scale 1 (110 kV).
 */
struct TowerPlan {
  double scale;
  double lowest_arm; ///< height of the lowest crossarm above ground
  double insulator;  ///< length of a suspension string
  std::vector<Arm> arms;
  double peak; ///< above the lowest crossarm
};

TowerPlan
towerPlan(const CorridorSettings& settings, TowerType type)
{
  TowerPlan plan;
  plan.scale = std::clamp(0.73 + settings.voltage / 400, 0.85, 1.75);
  const double f = plan.scale;
  plan.lowest_arm = 20 * f;
  plan.insulator = std::clamp(settings.voltage / 100, 0.9, 3.8) + 0.4;
  const auto pair = [&](double offset, double height) {
    plan.arms.push_back({-offset * f, height * f});
    plan.arms.push_back({offset * f, height * f});
  };
  if (type == TowerType::Donau) {
    pair(3.0, 0);
    pair(6.0, 0);
    pair(4.3, 4.4);
    plan.peak = 9 * f;
  }
  else if (type == TowerType::Barrel) {
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
  return plan;
}

struct Pylon {
  Point base = Point::Zero();
  Point along = Point::UnitX(), across = Point::UnitY(); ///< unit vectors in plan
  double extension = 0; ///< of the body, so that neighbors differ
  bool tension = false; ///< strings in line with the wires
};

/** The corners of a square of half width \a half around a pylon's axis. */
void
square(const Pylon& pylon, double height, double half, Point (&corners)[4])
{
  const double side[4][2] = {{1, 1}, {1, -1}, {-1, -1}, {-1, 1}};
  for (int i = 0; i < 4; ++i)
    corners[i] = pylon.base + half * side[i][0] * pylon.along +
                 half * side[i][1] * pylon.across + height * Point::UnitZ();
}

void
addPylon(Scene& scene, const TowerPlan& plan, const Pylon& pylon, unsigned earth_wires)
{
  const double f = plan.scale;
  const double arm = plan.lowest_arm + pylon.extension, peak = arm + plan.peak;
  const double waist = 0.75 * f;
  Point bottom[4], middle[4], top[4];
  square(pylon, 0, 2.9 * f, bottom);
  square(pylon, arm, waist, middle);
  square(pylon, peak, 0.12 * f, top);
  addLattice(scene, bottom, middle, 6, 0.06 * f, PylonClass);
  addLattice(
      scene, middle, top, static_cast<int>(plan.peak / 1.6), 0.05 * f, PylonClass);

  // A crossarm: two lower chords and an upper one that meet at the tip, braced.
  for (const Arm& a : plan.arms) {
    const double z = arm + a.height, side = a.offset < 0 ? -1 : 1;
    const Point tip = pylon.base + a.offset * pylon.across + z * Point::UnitZ();
    const Point root = pylon.base + side * 0.5 * waist * pylon.across;
    const Point low[2] = {root + 0.5 * waist * pylon.along + z * Point::UnitZ(),
                          root - 0.5 * waist * pylon.along + z * Point::UnitZ()};
    const Point high = root + (z + 1.3 * f) * Point::UnitZ();
    scene.beam(low[0], tip, 0.05 * f, PylonClass, 0.5);
    scene.beam(low[1], tip, 0.05 * f, PylonClass, 0.5);
    scene.beam(high, tip, 0.05 * f, PylonClass, 0.5);
    const int bays = std::max(2, static_cast<int>(std::abs(a.offset) / 1.2));
    for (int i = 0; i < bays; ++i) {
      const double t = static_cast<double>(i) / bays, u = (i + 0.5) / bays;
      const Point on_high = high + u * (tip - high);
      for (const Point& corner : low) {
        scene.beam(corner + t * (tip - corner), on_high, 0.03 * f, PylonClass, 0.5);
        scene.beam(on_high,
                   corner + (t + 1.0 / bays) * (tip - corner),
                   0.03 * f,
                   PylonClass,
                   0.5);
      }
    }
    if (!pylon.tension)
      scene.beam(tip, tip - plan.insulator * Point::UnitZ(), 0.08, PylonClass, 0.4);
  }
  if (earth_wires == 2) // carried by two short horns
    for (const double side : {-1.0, 1.0})
      scene.beam(pylon.base + (peak - 1.5 * f) * Point::UnitZ(),
                 pylon.base + side * 2 * f * pylon.across + peak * Point::UnitZ(),
                 0.05 * f,
                 PylonClass,
                 0.5);
  scene.keep_clear.emplace_back(pylon.base.x(), pylon.base.y(), 7 * f);
}

/** Pylons from before the start to beyond the end; the line turns at one of them. */
std::vector<Pylon>
placePylons(const Scene& scene,
            const CorridorSettings& settings,
            double span,
            Random& random)
{
  std::vector<double> xs{random.uniform(0.12, 0.3) * span};
  xs.insert(xs.begin(), xs.front() - span * random.uniform(0.85, 1.15));
  while (xs.back() < settings.length)
    xs.push_back(xs.back() + span * random.uniform(0.85, 1.15));
  // The pylon nearest to the middle makes the turn, half of it for each leg.
  std::size_t turn = 0;
  for (std::size_t i = 0; i < xs.size(); ++i)
    if (std::abs(xs[i] - settings.length / 2) <
        std::abs(xs[turn] - settings.length / 2))
      turn = i;
  const double side = random.integer(0, 1) == 0 ? -1 : 1;
  const double lean = side * std::tan(0.5 * settings.angle * pi / 180);
  const double mean = -0.25 * lean * settings.length + random.uniform(-2, 2);
  std::vector<Pylon> pylons;
  for (const double x : xs) {
    const double y = mean + lean * std::abs(x - xs[turn]);
    Pylon pylon;
    pylon.base = Point(x, y, scene.terrain.height(x, y));
    pylon.extension = random.uniform(-1.5, 3);
    pylons.push_back(pylon);
  }
  for (std::size_t i = 0; i < pylons.size(); ++i) {
    const double direction = i < turn ? -lean : (i > turn ? lean : 0);
    pylons[i].along = Point(1, direction, 0).normalized();
    pylons[i].across = Point(-pylons[i].along.y(), pylons[i].along.x(), 0);
    pylons[i].tension = i == turn && std::abs(settings.angle) > 2;
  }
  return pylons;
}

/** Wires at one circuit position from pylon to pylon. */
struct Conductor {
  WireKind kind;
  double a, radius;
  unsigned bundle;
};

Point
attachment(const TowerPlan& plan, const Pylon& pylon, const Arm& arm, bool hangs)
{
  const double drop = hangs && !pylon.tension ? plan.insulator : 0;
  return pylon.base + arm.offset * pylon.across +
         (plan.lowest_arm + pylon.extension + arm.height - drop) * Point::UnitZ();
}

/** The loop that leads the current around a tension pylon, below the crossarm. */
void
addJumper(Scene& scene,
          const std::vector<Pylon>& pylons,
          std::size_t i,
          const Point& tip,
          double string)
{
  const auto toward = [&](std::size_t other) -> Point {
    Point d = pylons[other].base - pylons[i].base;
    d.z() = 0;
    return d.normalized();
  };
  const Point before = toward(i - 1), behind = toward(i + 1);
  Point last = tip + string * before;
  for (int k = 1; k <= 8; ++k) {
    const double t = k / 8.0;
    const Point next = tip + string * ((1 - t) * before + t * behind) -
                       string * 0.9 * 4 * t * (1 - t) * Point::UnitZ();
    scene.beam(last, next, 0.0135, PylonClass, 0.5);
    last = next;
  }
}

void
addConductors(Scene& scene,
              const CorridorSettings& settings,
              const TowerPlan& plan,
              const std::vector<Pylon>& pylons,
              const Arm& arm,
              const Conductor& conductor,
              int number)
{
  const bool hangs = conductor.kind == WireKind::Conductor;
  for (std::size_t i = 0; i + 1 < pylons.size(); ++i) {
    const Pylon &one = pylons[i], &two = pylons[i + 1];
    for (unsigned sub = 0; sub < conductor.bundle; ++sub) {
      const double aside = conductor.bundle == 1 ? 0 : (sub == 0 ? -0.2 : 0.2);
      const Point from = attachment(plan, one, arm, hangs) + aside * one.across;
      const Point to = attachment(plan, two, arm, hangs) + aside * two.across;
      CorridorWire wire;
      wire.kind = conductor.kind;
      wire.span = static_cast<int>(i);
      wire.number = number;
      WireParameters parameters;
      parameters.a = conductor.a;
      parameters.wind = settings.wind;
      parameters.radius = conductor.radius;
      parameters.front_string = hangs && one.tension ? plan.insulator : 0;
      parameters.back_string = hangs && two.tension ? plan.insulator : 0;
      addWire(scene, wire, from, to, parameters);
      if (hangs && i > 0 && one.tension)
        addJumper(scene, pylons, i, from, plan.insulator);
    }
  }
}

} // namespace

void
addHighVoltageLine(Scene& scene, const CorridorSettings& settings, Random& random)
{
  const TowerType type = settings.tower != TowerType::Any
                             ? settings.tower
                             : static_cast<TowerType>(random.integer(1, 3));
  const TowerPlan plan = towerPlan(settings, type);
  const double span = settings.span > 0 ? settings.span : 180 + settings.voltage * 0.4;
  const double a =
      settings.catenary > 0 ? settings.catenary : 950 + settings.voltage * 1.6;
  const unsigned bundle =
      settings.bundle > 0 ? settings.bundle : (settings.voltage >= 220 ? 2 : 1);
  const std::vector<Pylon> pylons = placePylons(scene, settings, span, random);
  for (const Pylon& pylon : pylons)
    addPylon(scene, plan, pylon, settings.earth_wires);

  // All conductors of a line are strung alike, give or take; earth wires tighter.
  int number = 0;
  for (const Arm& arm : plan.arms)
    addConductors(
        scene,
        settings,
        plan,
        pylons,
        arm,
        {WireKind::Conductor, a * random.uniform(0.985, 1.015), 0.0135, bundle},
        ++number);
  for (unsigned i = 0; i < settings.earth_wires; ++i) {
    const double offset =
        settings.earth_wires == 1 ? 0 : (i == 0 ? -2.0 : 2.0) * plan.scale;
    addConductors(scene,
                  settings,
                  plan,
                  pylons,
                  {offset, plan.peak},
                  {WireKind::Earth, 1.2 * a * random.uniform(0.985, 1.015), 0.008, 1},
                  ++number);
  }
}

} // namespace linelet::bench::corridor
