// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "surroundings.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Geometry>

namespace linelet {

namespace {

constexpr std::size_t sectors = 8, rings = 3;
// Clutter gathers by chance: a curve is more than that much denser than what is around.
constexpr double clumping = 1.5;
constexpr double few = 0.5; // points that a ring without any stands for

/** \brief Two directions across \a direction. */
std::array<Point, 2>
axesAcross(const Point& direction)
{
  const Point first = direction.unitOrthogonal();
  return {first, direction.cross(first)};
}

} // namespace

void
lookAhead(const TrackedScene& scene,
          const TrackState& state,
          double length,
          double gate,
          double ring,
          Surroundings& result)
{
  result.near.clear();
  const auto axes = axesAcross(state.direction);
  std::array<std::array<double, rings>, sectors> around{};
  double outside = 0, inside = 0;
  const double half = 0.5 * length;
  const double reach = std::sqrt(half * half + ring * ring);
  scene.grid.forEachWithin(state.ahead(half), reach, [&](Index i, double) {
    if (scene.owner[i] >= 0)
      return;
    const Point& p = scene.points[i];
    const double place = state.direction.dot(p - state.at);
    if (!(place > 0 && place <= length))
      return;
    const Point v = state.across(p - state.ahead(place));
    const double distance = v.norm();
    if (distance <= gate) {
      if (scene.surface[i])
        inside += 1;
      else
        result.near.push_back({place, i});
    }
    else if (distance <= ring) {
      outside += 1;
      const double angle = std::atan2(v.dot(axes[1]), v.dot(axes[0])) / (2 * M_PI);
      const auto sector = static_cast<std::size_t>((angle + 1) * sectors) % sectors;
      const double out = (distance - gate) / (ring - gate) * rings;
      around[sector][std::min(static_cast<std::size_t>(out), rings - 1)] += 1;
    }
  });
  const double area = M_PI * (ring * ring - gate * gate);
  const double volume = (outside + few) / (area * length);
  // A surface through the gate fills two opposite sectors, an edge of one a single one,
  // all the way out; another curve beside this one does not.
  double surface = 0;
  for (std::size_t k = 0; k < sectors / 2; ++k) {
    double strip = outside;
    for (std::size_t r = 0; r < rings; ++r)
      strip = std::min(strip, around[k][r] + around[k + sectors / 2][r]);
    surface = std::max(surface, rings * strip);
  }
  result.chi_square = result.freedom = 0;
  if (outside > 0) {
    for (std::size_t r = 0; r < rings; ++r) {
      const double inner = gate + (ring - gate) * static_cast<double>(r) / rings;
      const double outer = gate + (ring - gate) * static_cast<double>(r + 1) / rings;
      const double share =
          (outer * outer - inner * inner) / (ring * ring - gate * gate);
      const double mean = outside * share / sectors;
      for (std::size_t k = 0; k < sectors; ++k)
        result.chi_square += (around[k][r] - mean) * (around[k][r] - mean) / mean;
    }
    result.freedom = rings * sectors - 1;
  }
  const double gate_volume = M_PI * gate * gate * length;
  const double expected = std::max(surface * gate / (ring - gate), inside);
  result.background = clumping * (volume + expected / gate_volume);
  std::sort(result.near.begin(), result.near.end(), [](const auto& a, const auto& b) {
    return a.place != b.place ? a.place < b.place : a.index < b.index;
  });
}

} // namespace linelet
