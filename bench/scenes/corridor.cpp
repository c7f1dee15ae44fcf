// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "corridor_high_voltage.h"
#include "corridor_members.h"
#include "corridor_objects.h"
#include "corridor_planted.h"
#include "corridor_poles.h"
#include "corridor_scan.h"
#include "corridor_scene.h"

namespace linelet::bench {

namespace {

void
demand(bool right, const std::string& what)
{
  if (!right)
    throw std::invalid_argument("a corridor needs " + what);
}

void
check(const CorridorSettings& s)
{
  const auto within =
      [](double value, double low, double high, const std::string& name) {
        // Written so that NaN fails.
        demand(value >= low && value <= high,
               "--" + name + " from " + std::to_string(static_cast<int>(low)) + " to " +
                   std::to_string(static_cast<int>(high)));
      };
  within(s.length, 20, 20000, "length");
  within(s.width, 10, 2000, "width");
  demand(s.density > 0 && s.density <= 2000, "--density above 0, up to 2000");
  demand(s.length * s.width * s.density <= 1e9, "at most 1e9 pulses");
  within(s.altitude, 90, 5000, "altitude");
  demand(s.divergence > 0 && s.divergence <= 5, "--divergence above 0, up to 5");
  within(s.strips, 1, 100, "strips");
  within(s.range_noise, 0, 1, "range-noise");
  within(s.strip_error, 0, 1, "strip-error");
  within(s.voltage, 20, 800, "voltage");
  demand(s.span == 0 || (s.span >= 40 && s.span <= 1000), "--span 0, or 40 to 1000");
  demand(s.catenary == 0 || (s.catenary >= 300 && s.catenary <= 5000),
         "--catenary 0, or 300 to 5000");
  within(s.bundle, 0, 2, "bundle");
  within(s.earth_wires, 0, 2, "earth-wires");
  within(s.angle, -60, 60, "angle");
  within(s.wind, -60, 60, "wind");
  within(s.low_voltage, 0, 50, "low-voltage");
  within(s.low_voltage_wires, 1, 6, "low-voltage-wires");
  within(s.relief, 0, 60, "relief");
  within(s.trees, 0, 5000, "trees");
  within(s.bushes, 0, 5000, "bushes");
  within(s.houses, 0, 10000, "houses");
  within(s.cranes, 0, 1000, "cranes");
  within(s.fences, 0, 10000, "fences");
  within(s.gaps, 0, 200, "gaps");
  within(s.outliers, 0, 1, "outliers");
  within(s.thin_ground, 1, 1000000, "thin-ground");
  within(s.planted, 0, 10000, "planted");
}

/** The part of a wire that the scan covers; false if that is empty. */
bool
clip(CorridorWire& wire, const CorridorSettings& settings)
{
  const double half = 0.5 * settings.width;
  const auto inside = [&](const Point& p) {
    return p.x() >= 0 && p.x() <= settings.length && std::abs(p.y()) <= half;
  };
  // Where the border cuts the piece from p (inside) to q (outside).
  const auto cut = [&](const Point& p, const Point& q) -> Point {
    double t = 1;
    const auto limit = [&](double from, double to, double border) {
      if ((from - border) * (to - border) < 0)
        t = std::min(t, (border - from) / (to - from));
    };
    limit(p.x(), q.x(), 0);
    limit(p.x(), q.x(), settings.length);
    limit(p.y(), q.y(), -half);
    limit(p.y(), q.y(), half);
    return p + t * (q - p);
  };
  const Points& all = wire.points;
  std::size_t first = 0;
  while (first < all.size() && !inside(all[first]))
    ++first;
  if (first == all.size())
    return false;
  std::size_t last = first;
  while (last + 1 < all.size() && inside(all[last + 1]))
    ++last;
  Points kept(all.begin() + static_cast<std::ptrdiff_t>(first),
              all.begin() + static_cast<std::ptrdiff_t>(last) + 1);
  if (first > 0)
    kept.insert(kept.begin(), cut(all[first], all[first - 1]));
  if (last + 1 < all.size())
    kept.push_back(cut(all[last], all[last + 1]));
  wire.front_attached = first == 0;
  wire.back_attached = last + 1 == all.size();
  wire.points = std::move(kept);
  return wire.points.size() >= 2;
}

/** Drops wires outside the scan and renumbers references to them. */
void
clipWires(CorridorScan& scan,
          std::vector<CorridorWire> wires,
          const CorridorSettings& s)
{
  std::vector<std::int32_t> place(wires.size(), -1);
  for (std::size_t i = 0; i < wires.size(); ++i)
    if (clip(wires[i], s)) {
      place[i] = static_cast<std::int32_t>(scan.wires.size());
      scan.wires.push_back(std::move(wires[i]));
    }
  for (std::int32_t& wire : scan.wire)
    if (wire >= 0)
      wire = place[static_cast<std::size_t>(wire)];
}

/** Places the scene: a heading and a location in northern Germany. */
struct Placement {
  explicit Placement(Random& random)
  {
    heading = random.uniform(0, 2 * pi);
    origin.x() = 565000 + 10.0 * random.integer(0, 2000);
    origin.y() = 5930000 + 10.0 * random.integer(0, 2000);
    origin.z() = 5.0 * random.integer(2, 60);
  }

  double heading;
  Point origin;
};

void
toWorld(CorridorScan& scan,
        const CorridorSettings& settings,
        const Placement& placement)
{
  const double c = std::cos(placement.heading), s = std::sin(placement.heading);
  scan.shift = placement.origin;
  const auto turn = [&](Point& p) {
    const double x = p.x() - 0.5 * settings.length, y = p.y();
    p.x() = c * x - s * y;
    p.y() = s * x + c * y;
  };
  for (Point& p : scan.points) {
    turn(p);
    p = (p * 1000).array().round() / 1000; // a point file stores millimeters
  }
  for (CorridorWire& wire : scan.wires)
    for (Point& p : wire.points)
      turn(p);
  for (PlantedHazard& hazard : scan.planted)
    turn(hazard.wire);
}

} // namespace

CorridorScan
simulateCorridor(const CorridorSettings& settings, ProgressMonitor* monitor)
{
  check(settings);
  Random random(settings.seed);
  corridor::Scene scene{corridor::Terrain(random, settings.relief), {}, {}, {}, {}, {}};
  addHighVoltageLine(scene, settings, random);
  for (unsigned line = 1; line <= settings.low_voltage; ++line)
    addPoleLine(scene, settings, static_cast<int>(line), random);
  throwIfCanceled(monitor);
  addGaps(scene, settings.gaps, random);
  addObjects(scene, settings, random);
  std::vector<PlantedHazard> planted = plantHazards(scene, settings, random);
  throwIfCanceled(monitor);
  // Drawn before the scan, so that another scan of the same scene has the same
  // location.
  const Placement placement(random);
  CorridorScan result = scan(scene, settings, random, monitor);
  clipWires(result, std::move(scene.wires), settings);
  result.planted = std::move(planted);
  toWorld(result, settings, placement);
  return result;
}

} // namespace linelet::bench
