// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include <bench/scenes/scene.h>

#include "recipe.h"

namespace linelet::bench {

namespace {

using namespace scenes;

void
demand(bool right, const std::string& what)
{
  if (!right)
    throw std::invalid_argument("a scene needs " + what);
}

void
check(const SceneSettings& s)
{
  // Written so that NaN fails.
  demand(s.density == 0 || (s.density >= 0.1 && s.density <= 2000),
         "--density 0, or 0.1 to 2000");
  demand(s.wire_density == 0 || (s.wire_density >= 0.05 && s.wire_density <= 200),
         "--wire-density 0, or 0.05 to 200");
  demand(s.noise >= 0 && s.noise <= 1, "--noise from 0 to 1");
}

/** The longest stretch of a wire inside the extent; empty if there is none. */
Points
clip(const Points& all, double length, double width)
{
  const double half = 0.5 * width;
  Points best, run;
  const auto finish = [&] {
    if (run.size() > best.size())
      best = run;
    run.clear();
  };
  for (std::size_t i = 1; i < all.size(); ++i) {
    // The part of this piece inside (Liang and Barsky).
    const Point d = all[i] - all[i - 1];
    double from = 0, to = 1;
    const auto cut = [&](double start, double step, double border) {
      const double room = border - start; // inside: t step <= room
      if (step > 0)
        to = std::min(to, room / step);
      else if (step < 0)
        from = std::max(from, room / step);
      else if (room < 0)
        to = -1;
    };
    cut(all[i - 1].x(), d.x(), length);
    cut(-all[i - 1].x(), -d.x(), 0);
    cut(all[i - 1].y(), d.y(), half);
    cut(-all[i - 1].y(), -d.y(), half);
    if (from >= to) {
      finish();
      continue;
    }
    if (run.empty() || from > 0) {
      finish();
      run.push_back(all[i - 1] + from * d);
    }
    run.push_back(all[i - 1] + to * d);
    if (to < 1)
      finish();
  }
  finish();
  return best;
}

/** Copies the truth into \a scan, clipped to the extent. */
void
keepTruth(World& world, SceneScan& scan, double noise)
{
  std::vector<std::int32_t> place(world.wires.size(), -1);
  for (std::size_t i = 0; i < world.wires.size(); ++i) {
    SceneWire& wire = world.wires[i];
    wire.points = clip(wire.points, world.length, world.width);
    wire.noise = noise;
    if (wire.points.size() < 2)
      continue;
    place[i] = static_cast<std::int32_t>(scan.wires.size());
    scan.wires.push_back(std::move(wire));
  }
  for (std::int32_t& wire : scan.wire)
    if (wire >= 0)
      wire = place[static_cast<std::size_t>(wire)];
  for (const SceneStructure& s : world.structures) {
    const Points inside = clip({s.from, s.to}, world.length, world.width);
    if (inside.size() == 2)
      scan.structures.push_back({s.kind, inside[0], inside[1], s.radius});
  }
}

/** Turns and moves everything to a heading and location in northern Germany. */
void
toWorld(SceneScan& scan, const World& world, Random& random)
{
  const double heading = random.uniform(0, 2 * pi);
  scan.shift.x() = 565000 + 10.0 * random.integer(0, 2000);
  scan.shift.y() = 5930000 + 10.0 * random.integer(0, 2000);
  scan.shift.z() = 5.0 * random.integer(2, 60);
  const double c = std::cos(heading), s = std::sin(heading);
  const auto turn = [&](Point& p) {
    const double x = p.x() - 0.5 * world.length, y = p.y();
    p.x() = c * x - s * y;
    p.y() = s * x + c * y;
  };
  for (Point& p : scan.points) {
    turn(p);
    p = (p * 1000).array().round() / 1000; // a point file stores millimeters
  }
  for (SceneWire& wire : scan.wires)
    for (Point& p : wire.points)
      turn(p);
  for (SceneStructure& structure : scan.structures) {
    turn(structure.from);
    turn(structure.to);
  }
}

} // namespace

SceneScan
simulateScene(const SceneSettings& settings, ProgressMonitor* monitor)
{
  check(settings);
  // Different kinds with the same seed have nothing in common.
  Random random(settings.seed * 64 + static_cast<std::uint32_t>(settings.kind));
  Recipe recipe = drawRecipe(settings.kind, random);
  if (settings.density > 0)
    recipe.scan.density = settings.density;
  if (settings.wire_density > 0)
    recipe.wire_density = settings.wire_density;
  if (settings.noise > 0)
    recipe.scan.noise = settings.noise;
  World world{recipe.length,
              recipe.width,
              Relief(recipe.relief, random),
              recipe.beam,
              0.5 * recipe.wire_density / recipe.scan.density,
              recipe.aside,
              {},
              {},
              {},
              {},
              {},
              {}};
  build(world, settings.kind, recipe, random);

  SceneScan result;
  result.density = recipe.scan.density;
  result.noise = recipe.scan.noise;
  result.aside = recipe.aside ? recipe.beam : 0;
  scan(world, recipe.scan, random, result, monitor);
  keepTruth(world, result, std::hypot(recipe.scan.noise, recipe.scan.misfit));
  toWorld(result, world, random);
  return result;
}

} // namespace linelet::bench
