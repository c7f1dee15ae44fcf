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
// Clutter gathers by chance: a curve is denser than its surroundings by more than this
// factor.
constexpr double clumping = 1.5;
constexpr double few = 0.5; // points that an empty ring counts as

/** \brief Two directions across \a direction. */
std::array<Point, 2>
axesAcross(const Point& direction)
{
  const Point first = direction.unitOrthogonal();
  return {first, direction.cross(first)};
}

/** \brief Which of the eight equal sectors about the origin holds (x, y), counted from
 * the x axis to the y axis. Without branches, which would often be mispredicted. */
std::size_t
sectorOf(double x, double y)
{
  const bool below = y < 0, left = below ? x > 0 : x < 0; // once turned upward
  const bool steep = std::abs(y) >= std::abs(x);
  const std::size_t half = static_cast<std::size_t>(steep) ^ (left ? 3U : 0U);
  return half + (below ? sectors / 2 : 0);
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
  std::array<double, rings> outer{}; // squared radii
  for (std::size_t r = 0; r < rings; ++r)
    outer[r] = std::pow(gate + (ring - gate) * static_cast<double>(r + 1) / rings, 2);
  const double squared_gate = gate * gate;
  double outside = 0, inside = 0;
  const Tube tube = {state.at, state.direction, state.curvature, length, outer.back()};
  TubePoints& tubed = result.tubed;
  tubed.count = 0;
  const double sagitta = 0.5 * state.curvature.norm() * length * length;
  scene.grid.forEachRunInCylinder(state.at,
                                  state.at + length * state.direction,
                                  ring + sagitta,
                                  [&](std::size_t begin, std::size_t end) {
                                    appendPointsInTube(
                                        tube, scene.points(), begin, end, tubed);
                                  });
  for (std::size_t k = 0; k < tubed.count; ++k) {
    const std::size_t i = tubed.index[k];
    const double place = tubed.place[k], squared = tubed.squared[k];
    if (scene.taken[i])
      continue;
    if (squared > squared_gate) {
      outside += 1;
      std::size_t r = 0;
      for (std::size_t n = 0; n + 1 < rings; ++n)
        r += squared > outer[n] ? 1 : 0;
      const Point off = scene.points()[i] - state.at -
                        place * (state.direction + 0.5 * place * state.curvature);
      around[sectorOf(axes[0].dot(off), axes[1].dot(off))][r] += 1;
    }
    else if (scene.surface[i])
      inside += 1;
    else
      result.near.push_back({place, static_cast<Index>(i)});
  }
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
