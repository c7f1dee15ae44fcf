// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "corridor_planted.h"

#include <algorithm>
#include <cmath>

namespace linelet::bench::corridor {

namespace {

constexpr double rim = 8; // meters inside the scan

bool
isInside(const Point& p, const CorridorSettings& settings)
{
  return p.x() > rim && p.x() < settings.length - rim &&
         std::abs(p.y()) < 0.5 * settings.width - rim;
}

/** A round crown on a trunk, at the given distance below or beside the wire. */
bool
plantTree(Scene& scene, const Point& at, double distance, Random& random)
{
  const double radius = random.uniform(1.5, 3), lean = random.uniform(-0.9, 0.9);
  const double turn = random.uniform(0, 2 * pi);
  const Point down(std::sin(lean) * std::cos(turn),
                   std::sin(lean) * std::sin(turn),
                   -std::cos(lean));
  const Point center = at + (distance + radius) * down;
  const double ground = scene.terrain.height(center.x(), center.y());
  if (center.z() - radius < ground + 1)
    return false;
  scene.beam({center.x(), center.y(), ground}, center, 0.12, VegetationClass, 0.4);
  scene.crowns.push_back({center, Point::Constant(radius), random.uniform(0.4, 0.8)});
  return true;
}

/** A house with a flat roof at the given distance below the wire. */
bool
plantHouse(Scene& scene, const Point& at, double distance, Random& random)
{
  const double ground = scene.terrain.height(at.x(), at.y());
  const double roof = at.z() - distance;
  if (roof < ground + 2.5)
    return false;
  const double u = random.uniform(3, 6), v = random.uniform(3, 6);
  const auto corner = [&](double x, double y, double z) {
    return Point(at.x() + x * u, at.y() + y * v, z);
  };
  const auto quad =
      [&](const Point& a, const Point& b, const Point& c, const Point& d) {
        scene.panels.push_back({a, b, c, BuildingClass, 0.4F});
        scene.panels.push_back({a, c, d, BuildingClass, 0.4F});
      };
  quad(corner(-1, -1, roof),
       corner(1, -1, roof),
       corner(1, 1, roof),
       corner(-1, 1, roof));
  const double way[5][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {-1, -1}};
  for (int i = 0; i < 4; ++i)
    quad(corner(way[i][0], way[i][1], ground - 1),
         corner(way[i + 1][0], way[i + 1][1], ground - 1),
         corner(way[i + 1][0], way[i + 1][1], roof),
         corner(way[i][0], way[i][1], roof));
  return true;
}

} // namespace

std::vector<PlantedHazard>
plantHazards(Scene& scene, const CorridorSettings& settings, Random& random)
{
  constexpr int attempts = 60;
  std::vector<PlantedHazard> planted;
  for (unsigned i = 0; i < settings.planted && !scene.wires.empty(); ++i)
    for (int attempt = 0; attempt < attempts; ++attempt) {
      const int w = random.integer(0, static_cast<int>(scene.wires.size()) - 1);
      const CorridorWire& wire = scene.wires[static_cast<std::size_t>(w)];
      const int last = static_cast<int>(wire.points.size()) - 1;
      const Point at = wire.points[static_cast<std::size_t>(
          random.integer(last / 5, last - last / 5))];
      const double distance = random.uniform(0.8, 4);
      if (!isInside(at, settings))
        continue;
      const bool house = i % 3 == 2;
      if (house ? plantHouse(scene, at, distance, random)
                : plantTree(scene, at, distance, random)) {
        planted.push_back({house ? BuildingClass : VegetationClass, at, distance});
        break;
      }
    }
  return planted;
}

} // namespace linelet::bench::corridor
