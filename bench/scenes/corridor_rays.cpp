// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "corridor_rays.h"

namespace linelet::bench::corridor {

namespace {

constexpr double cell = 3, margin = 1; // samples along a ray are 2 margins apart

} // namespace

RayCaster::RayCaster(const Scene& scene, double beam) : scene_(scene), beam_(beam)
{
  low_ = Point::Constant(1e9);
  high_ = Point::Constant(-1e9);
  const auto grow = [&](const Point& p) {
    low_ = low_.cwiseMin(p);
    high_ = high_.cwiseMax(p);
  };
  for (const Member& m : scene.members) {
    grow(m.from);
    grow(m.to);
  }
  for (const Panel& p : scene.panels) {
    grow(p.a);
    grow(p.b);
    grow(p.c);
  }
  for (const Crown& c : scene.crowns) {
    grow(c.center - c.radii);
    grow(c.center + c.radii);
  }
  low_ -= Point::Constant(3 * margin);
  high_ += Point::Constant(3 * margin);
  top_ = high_.z();
  cells_ = PlanCells(low_, high_, cell);

  std::uint32_t id = 0;
  for (const Member& m : scene.members) {
    const Point thick = Point::Constant(m.radius + beam_);
    insert(id++, m.from.cwiseMin(m.to) - thick, m.from.cwiseMax(m.to) + thick);
  }
  for (const Panel& p : scene.panels)
    insert(id++, p.a.cwiseMin(p.b).cwiseMin(p.c), p.a.cwiseMax(p.b).cwiseMax(p.c));
  for (const Crown& c : scene.crowns)
    insert(id++, c.center - c.radii, c.center + c.radii);
  seen_.assign(id, 0);
}

void
RayCaster::insert(std::uint32_t id, const Point& low, const Point& high)
{
  cells_.insert(id, low - Point::Constant(margin), high + Point::Constant(margin));
}

const std::vector<Hit>&
RayCaster::cast(const Ray& ray, Random& random)
{
  hits_.clear();
  ++ray_;
  const double ground = terrainAlong(ray);
  const double begin = (top_ - ray.origin.z()) / ray.direction.z();
  const double plan = std::hypot(ray.direction.x(), ray.direction.y());
  const double step = plan > 1e-9 ? 2 * margin / plan : ground;
  for (double t = begin; t < ground + step; t += step) {
    const Point p = ray.at(std::min(t, ground));
    if (p.x() < low_.x() || p.y() < low_.y() || p.x() >= high_.x() ||
        p.y() >= high_.y())
      continue;
    for (const std::uint32_t id : cells_.at(p.x(), p.y()))
      if (seen_[id] != ray_) {
        seen_[id] = ray_;
        meet(id, ray, random);
      }
  }
  hits_.push_back({ground, GroundClass, 0.3F, 1, -1});
  hits_.erase(std::remove_if(hits_.begin(),
                             hits_.end(),
                             [&](const Hit& hit) { return hit.t > ground; }),
              hits_.end());
  std::stable_sort(
      hits_.begin(), hits_.end(), [](const Hit& a, const Hit& b) { return a.t < b.t; });
  return hits_;
}

void
RayCaster::meet(std::uint32_t id, const Ray& ray, Random& random)
{
  std::size_t i = id;
  if (i < scene_.members.size())
    return meetMember(scene_.members[i], ray);
  i -= scene_.members.size();
  if (i < scene_.panels.size())
    return meetPanel(scene_.panels[i], ray);
  meetCrown(scene_.crowns[i - scene_.panels.size()], ray, random);
}

void
RayCaster::meetMember(const Member& member, const Ray& ray)
{
  const Point axis = member.to - member.from, off = ray.origin - member.from;
  const double length2 = axis.squaredNorm(), slant = axis.dot(ray.direction);
  const double across = length2 - slant * slant; // |axis|^2 sin^2
  double u = 0;
  if (across > 1e-12 * length2)
    u = (off.dot(axis) - off.dot(ray.direction) * slant) / across;
  u = std::clamp(u, 0.0, 1.0);
  const Point on = member.from + u * axis;
  const double t = (on - ray.origin).dot(ray.direction);
  const double d = (ray.at(t) - on).norm(), r = member.radius;
  if (d >= beam_ + r)
    return;
  // The strip's share of the disc: its width times the chord at its position.
  const double width = std::min(d + r, beam_) - std::max(d - r, -beam_);
  const double place = std::min(d, beam_) / beam_;
  const double chord = r >= beam_ ? 1 : std::sqrt(std::max(0.0, 1 - place * place));
  const double fraction = std::min(1.0, 1.27 * chord * width / (2 * beam_));
  if (fraction > 0.003)
    hits_.push_back(
        {t, member.classification, member.reflectivity, fraction, member.wire});
}

void
RayCaster::meetPanel(const Panel& panel, const Ray& ray)
{
  if (const auto t = meetTriangle(ray.origin, ray.direction, panel.a, panel.b, panel.c))
    hits_.push_back({*t, panel.classification, panel.reflectivity, 1, -1});
}

void
RayCaster::meetCrown(const Crown& crown, const Ray& ray, Random& random)
{
  const Point o = (ray.origin - crown.center).cwiseQuotient(crown.radii);
  const Point d = ray.direction.cwiseQuotient(crown.radii);
  const double a = d.squaredNorm(), b = o.dot(d), c = o.squaredNorm() - 1;
  const double root = b * b - a * c;
  if (root <= 0)
    return;
  const double end = (-b + std::sqrt(root)) / a;
  double t = (-b - std::sqrt(root)) / a;
  while (true) {
    t -= crown.free_path * std::log(1 - random.uniform(0, 1));
    if (t >= end)
      return;
    hits_.push_back({t,
                     VegetationClass,
                     static_cast<float>(random.uniform(0.3, 0.6)),
                     random.uniform(0.15, 0.8),
                     -1});
  }
}

double
RayCaster::terrainAlong(const Ray& ray) const
{
  // Fixed-point iteration: gentle slopes and steep rays make it contract fast.
  double t = -ray.origin.z() / ray.direction.z();
  for (int i = 0; i < 8; ++i) {
    const Point p = ray.at(t);
    t += (scene_.terrain.height(p.x(), p.y()) - p.z()) / ray.direction.z();
  }
  return t;
}

} // namespace linelet::bench::corridor
