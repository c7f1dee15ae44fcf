// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/network/clearances.h"

#include <algorithm>
#include <cmath>

#include <linelet/support/threads.h>

#include "powerline/pieces/candidates.h"

namespace linelet::powerline {

namespace {

constexpr double sample_step = 1;    // meters along a wire
constexpr double farthest = 30;      // meters, vegetation farther away is ignored
constexpr double company_radius = 1; // meters
constexpr std::size_t company = 3;   // neighbors, otherwise it is a bird or noise
constexpr double support_zone = 6;   // meters around supports, where fittings hang
// Meters before a free end, where other points are mostly the rest of the wire or of
// its twin.
constexpr double free_zone = 1;

} // namespace

Clearance
lowestAboveGround(const Catenary& curve, const Ground& ground)
{
  Clearance lowest;
  const int steps =
      std::max(1, static_cast<int>(std::ceil((curve.to - curve.from) / sample_step)));
  for (int k = 0; k <= steps; ++k) {
    const Point p = curve.at(curve.from + (curve.to - curve.from) * k / steps);
    const double terrain = ground.heightAt(p.x(), p.y());
    if (!(p.z() - terrain >= lowest.distance))
      lowest = {p.z() - terrain, p, {p.x(), p.y(), terrain}};
  }
  return lowest;
}

void
measureClearances(PowerLineNetwork& network,
                  const Candidates& candidates,
                  const PowerLineSettings& settings)
{
  if (network.ground.heights.empty())
    return; // nothing but the line: other points are the rest of wires
  Points others;
  for (std::size_t k = 0; k < candidates.points.size(); ++k) {
    const std::uint8_t c = network.classes[candidates.input[k]];
    if (c != wire_class && c != pylon_class && c != connector_class)
      others.push_back(candidates.points[k]);
  }
  const UniformGrid grid(others, 2);
  const double reach = std::max(farthest, 2 * settings.clearance);
  const auto count = static_cast<std::ptrdiff_t>(network.wires.size());
#pragma omp parallel for schedule(dynamic) num_threads(threadCount(settings.threads))
  for (std::ptrdiff_t w = 0; w < count; ++w) {
    Wire& wire = network.wires[static_cast<std::size_t>(w)];
    const Catenary& c = wire.curve;
    wire.ground = lowestAboveGround(c, network.ground);
    const int steps =
        std::max(1, static_cast<int>(std::ceil((c.to - c.from) / sample_step)));
    const double from = c.from + (wire.front_support == 0 ? free_zone : 0);
    const double to = c.to - (wire.back_support == 0 ? free_zone : 0);
    for (int k = 0; k <= steps; ++k) {
      const double s = c.from + (c.to - c.from) * k / steps;
      const Point p = c.at(s);
      if ((wire.front_support != 0 && s - c.from < support_zone) ||
          (wire.back_support != 0 && c.to - s < support_zone))
        continue;
      // Anything farther than the best so far does not matter.
      const double limit = wire.vegetation.known() ? wire.vegetation.distance : reach;
      const Index near = grid.nearest(p, limit);
      if (near == UniformGrid::none ||
          grid.countWithin(others[near], company_radius) <= company)
        continue;
      const double beside = c.along(others[near]);
      if (beside < from || beside > to)
        continue;
      wire.vegetation = {(others[near] - p).norm(), p, others[near]};
    }
  }
}

} // namespace linelet::powerline
