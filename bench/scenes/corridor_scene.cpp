// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "corridor_scene.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace linelet::bench::corridor {

Terrain::Terrain(Random& random, double relief)
    : slope_x_(relief / 400 * random.uniform(-0.5, 0.5)),
      slope_y_(relief / 400 * random.uniform(-0.5, 0.5))
{
  // Long waves carry the relief; short ones stay low, as in fields and meadows.
  for (const double length : {420.0, 260.0, 170.0, 95.0, 45.0, 22.0}) {
    const double direction = random.uniform(0, 2 * pi);
    const double k = 2 * pi / (length * random.uniform(0.8, 1.2));
    const double share = length > 80 ? length / 900 : length / 3000;
    waves_.push_back({k * std::cos(direction),
                      k * std::sin(direction),
                      random.uniform(0, 2 * pi),
                      relief * share * random.uniform(0.5, 1)});
  }
}

double
Terrain::height(double x, double y) const
{
  double z = slope_x_ * x + slope_y_ * y;
  for (const Wave& wave : waves_)
    z += wave.amplitude * std::sin(wave.kx * x + wave.ky * y + wave.phase);
  return z;
}

double
Scene::lowestWire(double x, double y, double reach) const
{
  double lowest = std::numeric_limits<double>::infinity();
  for (const CorridorWire& wire : wires)
    for (const Point& p : wire.points)
      if (std::hypot(p.x() - x, p.y() - y) <= reach)
        lowest = std::min(lowest, p.z());
  return lowest;
}

bool
Scene::take(double x, double y, double radius)
{
  for (const Point& disc : keep_clear)
    if (std::hypot(disc.x() - x, disc.y() - y) < disc.z() + radius)
      return false;
  keep_clear.emplace_back(x, y, radius);
  return true;
}

} // namespace linelet::bench::corridor
