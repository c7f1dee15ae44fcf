// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>

#include "relief.h"

namespace linelet::bench::scenes {

namespace {

/** A value in [0, 1] for a corner of the grid (finalizer of MurmurHash3). */
double
cornerValue(std::int64_t x, std::int64_t y, std::int64_t z, std::uint32_t seed)
{
  std::uint64_t h = static_cast<std::uint64_t>(x) * 0x9E3779B97F4A7C15ULL;
  h ^= static_cast<std::uint64_t>(y) * 0xC2B2AE3D27D4EB4FULL + (h << 6) + (h >> 2);
  h ^= static_cast<std::uint64_t>(z) * 0x165667B19E3779F9ULL + (h << 6) + (h >> 2);
  h ^= seed;
  h ^= h >> 33;
  h *= 0xFF51AFD7ED558CCDULL;
  h ^= h >> 33;
  h *= 0xC4CEB9FE1A85EC53ULL;
  h ^= h >> 33;
  return static_cast<double>(h >> 11) * 0x1.0p-53;
}

} // namespace

double
smoothNoise(const Point& p, std::uint32_t seed)
{
  const double fx = std::floor(p.x()), fy = std::floor(p.y()), fz = std::floor(p.z());
  const auto ease = [](double t) { return t * t * (3 - 2 * t); };
  const double u = ease(p.x() - fx), v = ease(p.y() - fy), w = ease(p.z() - fz);
  double sum = 0;
  for (int i = 0; i < 8; ++i) {
    const int dx = i & 1, dy = (i >> 1) & 1, dz = i >> 2;
    const double weight = (dx ? u : 1 - u) * (dy ? v : 1 - v) * (dz ? w : 1 - w);
    sum += weight * cornerValue(static_cast<std::int64_t>(fx) + dx,
                                static_cast<std::int64_t>(fy) + dy,
                                static_cast<std::int64_t>(fz) + dz,
                                seed);
  }
  return sum;
}

Relief::Relief(const ReliefPlan& plan, Random& random) : plan_(plan)
{
  const double rise = std::tan(plan.slope * pi / 180);
  slope_x_ = rise * std::cos(plan.direction);
  slope_y_ = rise * std::sin(plan.direction);
  for (const double length : {420.0, 260.0, 170.0, 95.0, 45.0, 22.0}) {
    const double direction = random.uniform(0, 2 * pi);
    const double k = 2 * pi / (length * random.uniform(0.8, 1.2));
    const double share = length > 80 ? length / 900 : length / 3000;
    const double phase = random.uniform(0, 2 * pi);
    waves_.push_back({k * std::cos(direction),
                      k * std::sin(direction),
                      phase,
                      plan.hills * share * random.uniform(0.5, 1)});
  }
  seed_ = static_cast<std::uint32_t>(random.integer(0, 1 << 30));
}

double
Relief::bank(double x, double y) const
{
  // Distance into the river; its banks meander by some meters.
  const double bend = 6 * std::sin(y / 23 + 1);
  return std::min(x - plan_.river_from - bend, plan_.river_to + bend - x);
}

double
Relief::height(double x, double y) const
{
  double z = slope_x_ * x + slope_y_ * y;
  for (const Wave& wave : waves_)
    z += wave.amplitude * std::sin(wave.kx * x + wave.ky * y + wave.phase);
  if (plan_.rocks > 0)
    for (const double size : {1.3, 4.0}) {
      const double bump = smoothNoise(Point(x / size, y / size, 0), seed_);
      z += plan_.rocks * size / 4 * std::max(0.0, bump - 0.6) / 0.4;
    }
  if (plan_.river_to > plan_.river_from) {
    // The banks fall to the water within 25 m.
    const double water = -plan_.hills, t = std::clamp((bank(x, y) + 25) / 25, 0.0, 1.0);
    z = (1 - t) * std::max(z, water + 1) + t * water;
  }
  return z;
}

bool
Relief::water(double x, double y) const
{
  return plan_.river_to > plan_.river_from && bank(x, y) > 0;
}

} // namespace linelet::bench::scenes
