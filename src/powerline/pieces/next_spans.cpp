// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/pieces/next_spans.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include <linelet/support/progress_monitor.h>

#include "powerline/line_priors.h"
#include "powerline/pieces/counts.h"
#include "powerline/pieces/data_border.h"
#include "powerline/pieces/evidence.h"
#include "powerline/pieces/growth.h"
#include "powerline/pieces/span_model.h"
#include "powerline/terrain/underside.h"

namespace linelet::powerline {

namespace {

constexpr double sharpest_turn = 0.6;                     // radians, in plan
constexpr double steepest_down = 0.35, steepest_up = 0.2; // slope at a support
constexpr double tube = 0.4;                  // meters around a direction to try
constexpr double expected_points = 12;        // on the stretch to try
constexpr double shortest = 12, longest = 40; // meters of it
// The counts of clumps of points in crowns look like parts of wires, so a search over
// many places needs more evidence.
constexpr double sure = 1.6;
constexpr std::size_t most_grown = 3; // directions per end

/** A direction from the end of a wire. */
struct Ray {
  SpanModel model;
  double evidence = 0;
};

Point
endOf(const SpanModel& m, int side)
{
  return m.at(side == 0 ? m.begin : m.end);
}

// Whether another wire begins about where this one ends, and continues it.
bool
goesOn(const std::vector<Piece>& wires, std::size_t w, int side)
{
  const SpanModel& m = wires[w].model;
  const Point end = endOf(m, side);
  const Eigen::Vector2d out = (side == 0 ? -1 : 1) * m.direction;
  for (std::size_t other = 0; other < wires.size(); ++other) {
    if (other == w)
      continue;
    const SpanModel& o = wires[other].model;
    const double s = o.along(end);
    if (s < o.begin - priors.drop_reach || s > o.end + priors.drop_reach)
      continue;
    const Point offset = end - o.at(std::clamp(s, o.begin, o.end));
    if (offset.norm() > priors.drop_reach)
      continue;
    const double ahead = std::max(out.dot((endOf(o, 0) - end).head<2>()),
                                  out.dot((endOf(o, 1) - end).head<2>()));
    if (ahead > priors.drop_reach)
      return true;
  }
  return false;
}

std::vector<Ray>
raysFrom(const Growth& growth, const Piece& wire, int side)
{
  const SpanModel& known = wire.model;
  const double density = bin_length * static_cast<double>(wire.members.size()) /
                         std::max(bin_length, known.length());
  const double length =
      std::clamp(bin_length * expected_points / density, shortest, longest);
  const Eigen::Vector2d out = (side == 0 ? -1 : 1) * known.direction;
  const Point end = endOf(known, side);
  const double step = 2 * tube / length;
  std::vector<Ray> rays;
  for (double turn = -sharpest_turn; turn <= sharpest_turn; turn += step)
    for (double rise = -steepest_down; rise <= steepest_up; rise += step) {
      Ray ray;
      SpanModel& m = ray.model;
      m.origin = end.head<2>();
      m.direction = Eigen::Rotation2Dd(turn) * out;
      m.z = {end.z(), rise, priors.usual_bend};
      m.begin = 0;
      m.end = length;
      m.tolerance = tube;
      for (double s = 0; s < length; s += bin_length) {
        const Bin bin = growth.look(m, s, s + bin_length, tube);
        const double reach = std::max(ring_radius, 2 * tube);
        ray.evidence += logWire({static_cast<double>(bin.tube),
                                 static_cast<double>(bin.ring),
                                 reach * reach / (tube * tube) - 1},
                                density,
                                priors.hidden);
      }
      if (ray.evidence > 0)
        rays.push_back(std::move(ray));
    }
  std::stable_sort(rays.begin(), rays.end(), [](const Ray& a, const Ray& b) {
    return a.evidence > b.evidence;
  });
  if (rays.size() > most_grown)
    rays.resize(most_grown);
  return rays;
}

// The wire with the most evidence along \a rays; without members if there is none.
Piece
bestAlong(const Growth& growth,
          const std::vector<Ray>& rays,
          const PowerLineSettings& settings)
{
  const double far = std::numeric_limits<double>::infinity();
  Piece best;
  double most = sure * priors.alone;
  for (const Ray& ray : rays) {
    Piece piece;
    piece.model = ray.model;
    if (!growth.collect(piece, tube) || !growth.extend(piece, -far, far, true))
      continue;
    for (Piece& part : growth.betweenSupports(std::move(piece))) {
      const Evidence evidence = weigh(growth, part, settings);
      if (!evidence.hangs || evidence.likelihood <= most)
        continue;
      most = evidence.likelihood;
      best = std::move(part);
    }
  }
  return best;
}

} // namespace

void
addNextSpans(Growth& growth,
             std::vector<Piece>& wires,
             const Underside& underside,
             const PowerLineSettings& settings,
             ProgressMonitor* monitor)
{
  // Wires found here have ends as well.
  for (std::size_t w = 0; w < wires.size(); ++w)
    for (int side = 0; side < 2; ++side) {
      throwIfCanceled(monitor);
      if (leavesData(wires[w].model, side, underside) || goesOn(wires, w, side))
        continue;
      Piece next = bestAlong(growth, raysFrom(growth, wires[w], side), settings);
      if (next.members.empty())
        continue;
      growth.claim(next, static_cast<int>(wires.size()));
      wires.push_back(std::move(next));
    }
}

} // namespace linelet::powerline
