// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/terrain/shows_terrain.h"

#include <algorithm>
#include <bitset>
#include <cmath>
#include <limits>

#include <linelet/tensor/point_moments.h>
#include <linelet/tensor/shape_factors.h>

#include "powerline/terrain/plan_extent.h"

namespace linelet::powerline {

namespace {

constexpr double plan_cell = 8; // meters; the lowest point of each is examined
constexpr int parts = 4;        // of a cell, along each axis
constexpr int covered = 12;     // parts with points, of 16, where a surface lies
constexpr double reach = 1.5;   // meters around it
constexpr double linear = 0.7;  // linearity of what belongs to a line
constexpr std::size_t least_points = 5; // there, to distinguish a line from a surface

// Wire guards, conductors, towers and connectors (ASPRS).
constexpr std::uint8_t first_part = 13, last_part = 16;

/** A place and its surroundings. */
struct Place {
  Point lowest = Point::Constant(std::numeric_limits<double>::infinity());
  PointMoments moments; // of points nearby, about the lowest
  std::bitset<static_cast<std::size_t>(parts) * parts> occupied;

  void
  add(const Point& p, std::size_t part)
  {
    occupied.set(part);
    const Point v = p - lowest;
    if (v.squaredNorm() <= reach * reach)
      moments.add(v);
  }

  /** Whether the lowest points form a line. A sparse scan line is one too, but has
   * others beside it. */
  bool
  isLinear() const
  {
    return occupied.count() < covered &&
           linearityOf(moments.covariance().matrix()) >= linear;
  }
};

bool
surfaceLiesLowest(const Points& points)
{
  const PlanExtent extent = planExtent(points, plan_cell);
  if (extent.points == 0)
    return true;
  const double most = static_cast<double>(extent.points) / 64 + 1e4;
  double cell = plan_cell;
  while (extent.cells(cell) > most)
    cell *= 2;
  const Eigen::Vector2d corner = rasterCorner(extent.low, cell);
  const Eigen::Array2d sides = ((extent.high - corner).array() / cell + 1).floor();
  const auto columns = static_cast<std::size_t>(sides.x());
  std::vector<Place> places(columns * static_cast<std::size_t>(sides.y()));
  const auto at = [&](const Point& p) {
    return Eigen::Vector2d((p.head<2>() - corner) / cell);
  };
  const auto placeOf = [&](const Point& p) -> Place& {
    const Eigen::Vector2d place = at(p);
    return places[static_cast<std::size_t>(place.y()) * columns +
                  static_cast<std::size_t>(place.x())];
  };
  const auto partOf = [&](const Point& p) {
    const Eigen::Vector2d place = at(p);
    const Eigen::Array2d inside = parts * (place.array() - place.array().floor());
    return static_cast<std::size_t>(inside.y()) * parts +
           static_cast<std::size_t>(inside.x());
  };
  const auto takesPart = [&](const Point& p) {
    return p.allFinite() && extent.contains(p);
  };
  for (const Point& p : points)
    if (takesPart(p))
      if (Place& place = placeOf(p); p.z() < place.lowest.z())
        place.lowest = p;
  for (const Point& p : points)
    if (takesPart(p))
      placeOf(p).add(p, partOf(p));
  std::size_t lines = 0, others = 0;
  for (const Place& place : places)
    if (place.moments.count >= least_points)
      ++(place.isLinear() ? lines : others);
  return lines <= others;
}

} // namespace

bool
showsTerrain(const Points& points, const std::vector<std::uint8_t>& classes)
{
  const bool only_parts =
      !classes.empty() &&
      std::all_of(classes.begin(), classes.end(), [](std::uint8_t c) {
        return c >= first_part && c <= last_part;
      });
  return !only_parts && surfaceLiesLowest(points);
}

} // namespace linelet::powerline
