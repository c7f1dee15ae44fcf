// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/powerline/find_hazards.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include <linelet/support/threads.h>

#include "powerline/hazards/fall_in.h"
#include "powerline/hazards/other_lines.h"
#include "powerline/hazards/stretches.h"
#include "powerline/hazards/wire_cells.h"
#include "powerline/hazards/wire_curve.h"
#include "support/parallel_failure.h"

namespace linelet::powerline {

namespace {

constexpr double terrain_step = 0.5; // meters along and beside a wire, over the terrain

/** Approaches of one wire, by what comes near: kind, and id of a support. */
using ByKind = std::map<std::pair<HazardKind, int>, std::vector<Approach>>;

void
approachTerrain(const Ground& ground,
                const WireCurve& curve,
                double limit,
                std::vector<Approach>& out)
{
  if (ground.heights.empty() || !(limit > 0))
    return;
  const Point ends = curve.at(curve.to()) - curve.at(curve.from());
  const Point across = Point(-ends.y(), ends.x(), 0).normalized();
  const int pieces = std::max(
      1, static_cast<int>(std::ceil((curve.to() - curve.from()) / terrain_step)));
  const int aside = static_cast<int>(limit / terrain_step);
  for (int k = 0; k <= pieces; ++k) {
    const Point p = curve.at(curve.from() + (curve.to() - curve.from()) * k / pieces);
    for (int j = -aside; j <= aside; ++j) {
      Point place = p + j * terrain_step * across;
      place.z() = ground.heightAt(place.x(), place.y());
      if (!((p - place).squaredNorm() < limit * limit))
        continue; // also where the terrain is unknown
      if (const Approach near = approach(curve, place, limit); near.from <= near.to)
        out.push_back(near);
    }
  }
}

std::vector<ByKind>
approachesOf(const PowerLineNetwork& network,
             const std::vector<WireCurve>& curves,
             const Surroundings& surroundings,
             const ClearanceLimits& limits,
             unsigned threads)
{
  std::vector<ByKind> all(network.wires.size());
  // Points are assigned to wires in order, so that threads do not affect the result.
  std::vector<Indices> near(network.wires.size());
  const WireCells cells(network.wires, std::max(1.0, limits.largest()));
  for (std::size_t i = 0; i < surroundings.points.size(); ++i)
    for (const std::uint32_t w : cells.near(surroundings.points[i]))
      near[w].push_back(static_cast<Index>(i));
  const auto count = static_cast<std::ptrdiff_t>(network.wires.size());
  ParallelFailure failure;
#pragma omp parallel for schedule(dynamic) num_threads(threadCount(threads))
  for (std::ptrdiff_t k = 0; k < count; ++k) {
    failure.guard([&] {
      const auto w = static_cast<std::size_t>(k);
      for (const Index i : near[w]) {
        const HazardKind kind = surroundings.kinds[i];
        const int support = surroundings.support[i];
        if (support != 0 && isOwnSupport(network, network.wires[w], support))
          continue;
        const Approach one =
            approach(curves[w], surroundings.points[i], limits.of(kind).low);
        if (one.from <= one.to)
          all[w][{kind, support}].push_back(one);
      }
      std::vector<Approach> terrain;
      approachTerrain(
          network.ground, curves[w], limits.of(HazardKind::Ground).low, terrain);
      if (!terrain.empty())
        all[w][{HazardKind::Ground, 0}] = std::move(terrain);
    });
  }
  failure.rethrow();
  return all;
}

} // namespace

Hazards
findHazards(const PowerLineNetwork& network,
            const Surroundings& surroundings,
            const ClearanceLimits& limits,
            unsigned threads,
            const ProgressMonitor* monitor)
{
  Hazards hazards;
  hazards.state = "as scanned";
  hazards.limits = limits;
  const std::vector<WireCurve> curves = curvesOf(network.wires);
  std::vector<ByKind> approaches =
      approachesOf(network, curves, surroundings, limits, threads);
  throwIfCanceled(monitor);
  for (std::size_t w = 0; w < approaches.size(); ++w)
    for (auto& [what, near] : approaches[w])
      appendStretches(network,
                      curves[w],
                      network.wires[w],
                      what.first,
                      what.second,
                      limits,
                      std::move(near),
                      hazards.clearances);
  appendWiresOfOtherLines(network, curves, limits, hazards.clearances);
  std::stable_sort(hazards.clearances.begin(),
                   hazards.clearances.end(),
                   [](const Encroachment& a, const Encroachment& b) {
                     return std::tie(a.wire, a.from) < std::tie(b.wire, b.from);
                   });
  for (std::size_t k = 0; k < hazards.clearances.size(); ++k)
    hazards.clearances[k].id = static_cast<int>(k) + 1;
  throwIfCanceled(monitor);
  hazards.crossings = findCrossings(network, curves, limits);
  hazards.fall_in = findFallIn(network, curves, surroundings, limits, threads);
  return hazards;
}

} // namespace linelet::powerline
