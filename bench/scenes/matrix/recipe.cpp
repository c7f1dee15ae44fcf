// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>

#include "recipe.h"

namespace linelet::bench::scenes {

namespace {

double
logUniform(Random& random, double low, double high)
{
  return std::exp(random.uniform(std::log(low), std::log(high)));
}

} // namespace

Recipe
drawRecipe(SceneKind kind, Random& random)
{
  Recipe r;
  const auto extent = [&](double length, double width) {
    r.length = length;
    r.width = width;
  };
  const auto sample = [&](double low, double high, double wire_low, double wire_high) {
    r.scan.density = logUniform(random, low, high);
    r.wire_density = logUniform(random, wire_low, wire_high);
  };
  r.scan.noise = logUniform(random, 0.012, 0.06);
  r.scan.altitude = random.uniform(350, 1200);
  r.scan.heading = random.uniform(0, 2 * pi);
  r.relief.hills = random.uniform(1, 12);
  sample(5, 10, 3, 8);
  switch (kind) {
  case SceneKind::Standard:
    break;
  case SceneKind::Sparse:
    extent(1000, 110);
    sample(0.8, 1.6, 0.3, 0.9);
    r.scan.noise = logUniform(random, 0.03, 0.15);
    r.scan.altitude = random.uniform(1200, 2500);
    r.beam = 0.3;
    break;
  case SceneKind::WideBeam:
    extent(800, 90);
    sample(1, 3, 0.3, 0.9);
    r.scan.noise = logUniform(random, 0.02, 0.06);
    r.scan.altitude = random.uniform(1200, 2500);
    r.beam = logUniform(random, 0.15, 0.35);
    r.aside = true;
    break;
  case SceneKind::Helicopter:
    extent(170, 32);
    sample(50, 70, 8, 20);
    r.scan.noise = logUniform(random, 0.01, 0.03);
    r.scan.altitude = random.uniform(120, 250);
    r.beam = 0.05;
    break;
  case SceneKind::Uav:
    extent(60, 18);
    sample(300, 400, 25, 60);
    r.scan.noise = logUniform(random, 0.01, 0.03);
    r.scan.altitude = random.uniform(50, 90);
    r.beam = 0.03;
    break;
  case SceneKind::Stubs:
    extent(random.uniform(26, 44), 32);
    sample(250, 350, 25, 60);
    r.scan.noise = logUniform(random, 0.01, 0.03);
    r.scan.altitude = random.uniform(60, 100);
    r.beam = 0.03;
    break;
  case SceneKind::Twin:
    sample(5, 8, 2, 5);
    break;
  case SceneKind::Triple:
    sample(5, 8, 3, 5);
    break;
  case SceneKind::Quad:
    extent(580, 70);
    sample(5, 8, 2, 4.5);
    r.scan.noise = logUniform(random, 0.03, 0.12);
    r.relief.hills = random.uniform(3, 40);
    break;
  case SceneKind::River:
    sample(2.5, 4, 1.5, 4);
    r.relief.hills = random.uniform(3, 8);
    r.relief.river_from = random.uniform(180, 220);
    r.relief.river_to = r.relief.river_from + random.uniform(600, 950);
    extent(r.relief.river_to + 250, 70);
    break;
  case SceneKind::Mountain:
  case SceneKind::MountainEmpty:
    extent(450, 90);
    sample(4, 8, 2, 6);
    r.relief.slope = random.uniform(30, 40);
    // Two in three lines climb; the others run across the slope.
    r.relief.direction = random.integer(0, 1) * pi;
    r.relief.direction += random.uniform(-0.5, 0.5);
    r.relief.direction += random.integer(0, 2) == 0 ? pi / 2 : 0;
    r.relief.hills = random.uniform(10, 25);
    r.relief.rocks = random.uniform(1, 3);
    break;
  case SceneKind::Street:
    extent(230, 64);
    sample(4, 16, 1.5, 4);
    r.relief.hills = random.uniform(0.5, 4);
    break;
  case SceneKind::Forest:
    extent(420, 60);
    sample(4, 6, 1, 2);
    break;
  case SceneKind::ForestEmpty:
    extent(300, 80);
    sample(4, 8, 2, 4);
    break;
  case SceneKind::Crossings:
    extent(360, 160);
    sample(4, 6, 2, 6);
    break;
  case SceneKind::Turns:
    extent(430, 250);
    sample(2, 3, 1.5, 4);
    break;
  case SceneKind::Strips:
    extent(360, 80);
    sample(6, 10, 4, 8);
    r.scan.noise = logUniform(random, 0.015, 0.03);
    r.scan.strips = static_cast<unsigned>(random.integer(2, 3));
    r.scan.misfit = random.uniform(0.05, 0.12);
    break;
  case SceneKind::Clutter:
  case SceneKind::ClutterEmpty:
    extent(380, 110);
    sample(4, 8, 2, 6);
    r.relief.hills = random.uniform(0.5, 3);
    break;
  case SceneKind::Town:
  case SceneKind::TownEmpty:
    extent(280, 180);
    sample(3, 5, 1.2, 3);
    r.relief.hills = random.uniform(0.5, 4);
    break;
  }
  return r;
}

} // namespace linelet::bench::scenes
