// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "corridor_poles.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "corridor_members.h"

namespace linelet::bench::corridor {

void
addPoleLine(Scene& scene, const CorridorSettings& settings, int line, Random& random)
{
  const double angle = random.uniform(62, 118) * pi / 180;
  const Point along(std::cos(angle), std::sin(angle), 0);
  // It passes between the pylons, never through one.
  double x0 = 0, room = -1;
  for (int attempt = 0; attempt < 8; ++attempt) {
    const double x = settings.length * (line - 0.5 + random.uniform(-0.3, 0.3)) /
                     settings.low_voltage;
    double nearest = 1e9;
    for (const Point& disc : scene.keep_clear) {
      const Point off(disc.x() - x, disc.y(), 0);
      nearest = std::min(nearest, off.cross(along).norm());
    }
    if (nearest > room) {
      room = nearest;
      x0 = x;
    }
  }
  const Point across(-along.y(), along.x(), 0);
  const double pitch = random.uniform(34, 46);
  // Only as far as the scan reaches, and one pole beyond.
  const double reach = 0.5 * settings.width / std::sin(angle) + pitch;
  std::vector<Point> bases;
  for (double s = -reach + random.uniform(0, 0.5) * pitch; s <= reach;
       s += pitch * random.uniform(0.93, 1.07)) {
    Point p = Point(x0, 0, 0) + s * along;
    p.z() = scene.terrain.height(p.x(), p.y());
    bases.push_back(p);
  }
  const double a = random.uniform(330, 480), half = 0.8;
  std::vector<double> tops;
  for (const Point& base : bases) {
    const double height = random.uniform(7.8, 9.2);
    const Point top = base + height * Point::UnitZ();
    const Point bar = top - 0.25 * Point::UnitZ();
    scene.beam(base, top, 0.13, PylonClass, 0.3);
    scene.beam(bar - (half + 0.1) * across,
               bar + (half + 0.1) * across,
               0.05,
               PylonClass,
               0.4);
    scene.keep_clear.emplace_back(base.x(), base.y(), 1.5);
    tops.push_back(bar.z() + 0.15);
  }
  const auto count = static_cast<int>(settings.low_voltage_wires);
  for (std::size_t i = 0; i + 1 < bases.size(); ++i)
    for (int w = 0; w < count; ++w) {
      const double offset = count == 1 ? 0 : half * (2.0 * w / (count - 1) - 1);
      Point from = bases[i] + offset * across, to = bases[i + 1] + offset * across;
      from.z() = tops[i];
      to.z() = tops[i + 1];
      CorridorWire wire;
      wire.kind = WireKind::LowVoltage;
      wire.line = line;
      wire.span = static_cast<int>(i);
      wire.number = w + 1;
      WireParameters parameters;
      parameters.a = a;
      parameters.wind = settings.wind;
      parameters.radius = 0.006;
      addWire(scene, wire, from, to, parameters);
    }
}

} // namespace linelet::bench::corridor
