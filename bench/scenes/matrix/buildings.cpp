// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "buildings.h"

namespace linelet::bench::scenes {

namespace {

void
addQuad(World& world, const Point& a, const Point& b, const Point& c, const Point& d)
{
  world.facets.push_back({a, b, c});
  world.facets.push_back({a, c, d});
}

/** Upright walls of a box. */
void
addWalls(World& world, const Plot& p, double l, double w, double low, double high)
{
  for (const double s : {-1.0, 1.0}) {
    addQuad(world,
            p.at(-l, s * w, low),
            p.at(l, s * w, low),
            p.at(l, s * w, high),
            p.at(-l, s * w, high));
    addQuad(world,
            p.at(s * l, -w, low),
            p.at(s * l, w, low),
            p.at(s * l, w, high),
            p.at(s * l, -w, high));
  }
}

/** A gabled roof over the strip of half width \a w, shifted by \a middle across. */
void
addGables(World& world,
          const Plot& p,
          double l,
          double middle,
          double w,
          double eaves,
          double ridge,
          double over)
{
  const double drop = over * (ridge - eaves) / w;
  for (const double s : {-1.0, 1.0}) {
    world.facets.push_back({p.at(s * l, middle - w, eaves),
                            p.at(s * l, middle + w, eaves),
                            p.at(s * l, middle, ridge)});
    addQuad(world,
            p.at(-l - over, middle + s * (w + over), eaves - drop),
            p.at(l + over, middle + s * (w + over), eaves - drop),
            p.at(l + over, middle, ridge),
            p.at(-l - over, middle, ridge));
  }
}

/** A solid block, such as a chimney. */
void
addBlock(World& world,
         const Plot& p,
         double x,
         double y,
         double half,
         double low,
         double high)
{
  Plot own = p;
  own.base = p.at(x, y, 0);
  addWalls(world, own, half, half, low, high);
  addQuad(world,
          own.at(-half, -half, high),
          own.at(half, -half, high),
          own.at(half, half, high),
          own.at(-half, half, high));
}

} // namespace

House
addHouse(World& world, const Plot& plot, Random& random)
{
  const double l = random.uniform(4.5, 8), w = random.uniform(3.5, 5.5);
  const double eaves = random.uniform(2.8, 6);
  const double ridge = eaves + w * random.uniform(0.5, 1.1);
  const double over = random.uniform(0.3, 0.7);
  addWalls(world, plot, l, w, -1, eaves);
  addGables(world, plot, l, 0, w, eaves, ridge, over);
  const double chimney = random.uniform(-0.6, 0.6) * l;
  addBlock(
      world, plot, chimney, 0.5, 0.35, ridge - 1, ridge + random.uniform(0.5, 1.2));
  if (random.integer(0, 2) == 0)
    world.add(StructureKind::Aerial,
              plot.at(0.3 * l, 0, ridge),
              plot.at(0.3 * l, 0, ridge + 2.5),
              0.03);
  if (random.integer(0, 2) == 0) { // a dormer
    const double at = random.uniform(-0.5, 0.5) * l;
    addBlock(world, plot, at, 0.55 * w, 0.9, eaves, eaves + 0.75 * (ridge - eaves));
  }
  return {l, w, eaves};
}

void
addHall(World& world, const Plot& plot, Random& random)
{
  const double l = random.uniform(12, 30), w = random.uniform(8, 15);
  const double eaves = random.uniform(5, 11);
  addWalls(world, plot, l, w, -1, eaves);
  const int ridges = random.integer(0, 3);
  if (ridges == 0) {
    addQuad(world,
            plot.at(-l, -w, eaves),
            plot.at(l, -w, eaves),
            plot.at(l, w, eaves),
            plot.at(-l, w, eaves));
    addWalls(world, plot, l, w, eaves, eaves + 0.6); // a parapet
    return;
  }
  const double half = w / ridges, rise = half * random.uniform(0.15, 0.5);
  for (int i = 0; i < ridges; ++i)
    addGables(world, plot, l, -w + half * (2 * i + 1), half, eaves, eaves + rise, 0);
}

} // namespace linelet::bench::scenes
