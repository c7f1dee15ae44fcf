// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "caster.h"

namespace linelet::bench::scenes {

namespace {

constexpr double cell = 2, margin = 0.75; // samples along a pulse are 2 margins apart

} // namespace

Caster::Caster(const World& world, std::uint32_t seed) : world_(world), seed_(seed)
{
  low_ = Point::Constant(1e9);
  high_ = Point::Constant(-1e9);
  const auto grow = [&](const Point& p) {
    low_ = low_.cwiseMin(p);
    high_ = high_.cwiseMax(p);
  };
  grow(world.relief.at(0, 0));
  for (const Rod& rod : world.rods) {
    grow(rod.from);
    grow(rod.to);
  }
  for (const Facet& f : world.facets) {
    grow(f.a);
    grow(f.b);
    grow(f.c);
  }
  for (const Crown& c : world.crowns) {
    grow(c.center - c.radii);
    grow(c.center + c.radii);
  }
  low_ -= Point::Constant(4 * margin);
  high_ += Point::Constant(4 * margin);
  cells_ = PlanCells(low_, high_, cell);
  std::uint32_t id = 0;
  for (const Rod& rod : world.rods) {
    const Point thick = Point::Constant(rod.reach);
    insert(id++, rod.from.cwiseMin(rod.to) - thick, rod.from.cwiseMax(rod.to) + thick);
  }
  for (const Facet& f : world.facets)
    insert(id++, f.a.cwiseMin(f.b).cwiseMin(f.c), f.a.cwiseMax(f.b).cwiseMax(f.c));
  for (const Crown& c : world.crowns)
    insert(id++, c.center - c.radii, c.center + c.radii);
  seen_.assign(id, 0);
}

void
Caster::insert(std::uint32_t id, const Point& low, const Point& high)
{
  cells_.insert(id, low - Point::Constant(margin), high + Point::Constant(margin));
}

const std::vector<Hit>&
Caster::cast(const Pulse& pulse, Random& random)
{
  hits_.clear();
  ++pulse_;
  const std::size_t rods = world_.rods.size(), facets = world_.facets.size();
  const double begin = (high_.z() - pulse.origin.z()) / pulse.direction.z();
  const double plan = std::hypot(pulse.direction.x(), pulse.direction.y());
  const double step = plan > 1e-6 ? 2 * margin / plan : 1e9;
  for (double t = begin; t < pulse.ground + step; t += step) {
    const Point p = pulse.at(std::min(t, pulse.ground));
    if ((p.head<2>().array() < low_.head<2>().array()).any() ||
        (p.head<2>().array() > high_.head<2>().array()).any())
      continue;
    for (const std::uint32_t id : cells_.at(p.x(), p.y())) {
      if (seen_[id] == pulse_)
        continue;
      seen_[id] = pulse_;
      if (id < rods)
        meetRod(world_.rods[id], pulse, random);
      else if (id < rods + facets)
        meetFacet(world_.facets[id - rods], pulse);
      else
        meetCrown(world_.crowns[id - rods - facets], pulse, random);
    }
  }
  hits_.erase(std::remove_if(hits_.begin(),
                             hits_.end(),
                             [&](const Hit& hit) { return hit.t > pulse.ground; }),
              hits_.end());
  std::stable_sort(
      hits_.begin(), hits_.end(), [](const Hit& a, const Hit& b) { return a.t < b.t; });
  return hits_;
}

void
Caster::meetRod(const Rod& rod, const Pulse& pulse, Random& random)
{
  const Point axis = rod.to - rod.from, off = pulse.origin - rod.from;
  const double length2 = axis.squaredNorm(), slant = axis.dot(pulse.direction);
  const double across = length2 - slant * slant; // |axis|^2 sin^2
  double u = 0;
  if (across > 1e-9 * length2)
    u = (off.dot(axis) - off.dot(pulse.direction) * slant) / across;
  // Pieces of a wire are consecutive: whatever lies beyond an end belongs to the next
  // one.
  if (rod.wire >= 0 && (u < 0 || u > 1))
    return;
  u = std::clamp(u, 0.0, 1.0);
  Point on = rod.from + u * axis;
  double t = (on - pulse.origin).dot(pulse.direction);
  const double d = (pulse.at(t) - on).norm();
  if (d > rod.reach || (rod.chance < 1 && random.uniform(0, 1) > rod.chance))
    return;
  if (d < rod.radius) { // the side that faces the sensor
    const double sine = std::sqrt(across / length2);
    t -=
        std::min(std::sqrt(rod.radius * rod.radius - d * d) / std::max(sine, 0.1), 1.0);
    on = pulse.at(t);
  }
  else if (rod.aside)
    on = pulse.at(t);
  hits_.push_back({t, on, rod.cover, rod.classification, rod.wire});
}

void
Caster::meetFacet(const Facet& facet, const Pulse& pulse)
{
  if (const auto t =
          meetTriangle(pulse.origin, pulse.direction, facet.a, facet.b, facet.c))
    hits_.push_back({*t, pulse.at(*t), 1, BuildingClass, -1});
}

void
Caster::meetCrown(const Crown& crown, const Pulse& pulse, Random& random)
{
  const Point o = (pulse.origin - crown.center).cwiseQuotient(crown.radii);
  const Point d = pulse.direction.cwiseQuotient(crown.radii);
  const double a = d.squaredNorm(), b = o.dot(d), c = o.squaredNorm() - 1;
  const double root = b * b - a * c;
  if (root <= 0)
    return;
  const double end = std::min((-b + std::sqrt(root)) / a, pulse.ground);
  double t = (-b - std::sqrt(root)) / a;
  while (true) {
    t -= crown.free_path * std::log(1 - random.uniform(0, 1));
    if (t >= end)
      return;
    // Free paths are drawn for the highest density; elsewhere leaves are skipped.
    const Point place = pulse.at(t);
    const double r = (o + t * d).norm();
    const double clump = smoothNoise(place / 0.7, seed_);
    const double rim = smoothNoise(place / 1.8, seed_ + 1);
    double leaves = clump > 0.5 ? 1 : 0.15;
    if (r < 0.6)
      leaves *= 0.25;
    if (r > 0.75 + 0.35 * rim)
      leaves = 0;
    if (random.uniform(0, 1) < leaves)
      hits_.push_back({t, place, random.uniform(0.1, 0.8), VegetationClass, -1});
  }
}

} // namespace linelet::bench::scenes
