// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/spans/service_drops.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "powerline/line_priors.h"
#include "powerline/pieces/bend.h"
#include "powerline/pieces/candidates.h"
#include "powerline/pieces/curve_pieces.h"
#include "powerline/pieces/evidence.h"
#include "powerline/pieces/growth.h"
#include "powerline/pieces/open_below.h"
#include "powerline/pieces/span_model.h"
#include "powerline/pieces/vertical_slice.h"
#include "powerline/spans/wire_with_ends.h"

namespace linelet::powerline {

namespace {

constexpr double least_seen = 4; // visible meters of a drop
constexpr double own_way = 0.95; // cosine to its line where they meet, at most
constexpr double step = 0.25;    // meters, on the way to a house
constexpr double eaves = 1;      // meters around the end of a drop, of its house ...
constexpr double a_roof = 3;     // ... points there

/** A stretch of a low line's wire where drops may branch off. */
struct Stretch {
  const SpanModel* wire;
  double low, high;
};

// Drops branch off at poles. A wire that clearly hangs is one span with poles at its
// ends; along others, trees may hide poles with kinks too small to detect.
std::vector<Stretch>
stretchesOf(const std::vector<WireWithEnds>& wires, const Candidates& candidates)
{
  std::vector<Stretch> all;
  for (const WireWithEnds& wire : wires) {
    const Piece& piece = wire.strand.piece;
    if (wire.leaves[0] || wire.leaves[1] || piece.thickness > 0 ||
        heightOf(piece, candidates) > priors.highest_pole ||
        (wire.ends[0].partner < 0 && wire.ends[1].partner < 0 &&
         wire.model().length() < priors.short_line))
      continue;
    const SpanModel& m = wire.model();
    const double first = m.along(wire.ends[0].place),
                 last = m.along(wire.ends[1].place);
    const double reach = priors.drop_beside;
    if (bendOf(piece, candidates.points).isAbove(flattest)) {
      all.push_back({&m, first - reach, first + reach});
      all.push_back({&m, last - reach, last + reach});
    }
    else
      all.push_back({&m, first - reach, last + reach});
  }
  return all;
}

// Meters from the end of \a m to where it branches off one of \a lines; negative if it
// does not.
double
wayTo(const SpanModel& m, int side, const std::vector<Stretch>& lines)
{
  double nearest = -1;
  for (const auto& [line, low, high] : lines) {
    // Where they cross in plan, or next to the end of m if they are nearly parallel.
    const double cosine = m.direction.dot(line->direction);
    const Eigen::Vector2d between = m.origin - line->origin;
    const double on_line =
        std::abs(cosine) > own_way
            ? line->along(m.at(side == 0 ? m.begin : m.end))
            : (between.dot(line->direction) - cosine * between.dot(m.direction)) /
                  (1 - cosine * cosine);
    const double place = std::clamp(on_line, low, high);
    const Point from = line->at(place);
    const double s = m.along(from);
    if (std::abs(m.tangent(s).dot(line->tangent(place))) > own_way)
      continue;
    const double on = side == 0 ? m.begin - s : s - m.end;
    if (on < -1 || on > priors.drop_reach || (nearest >= 0 && on >= nearest))
      continue;
    const Point offset = m.at(s) - from;
    if (offset.head<2>().norm() <= priors.drop_beside &&
        offset.z() >= -priors.drop_below && offset.z() <= priors.drop_beside)
      nearest = std::max(0.0, on);
  }
  return nearest;
}

// Meters from the end of \a m to the house that it leads to; negative if none is met
// while the position of the wire is certain.
double
wayHome(const SpanModel& m, int side, const Growth& growth)
{
  const Candidates& candidates = growth.candidates();
  const double edge = side == 0 ? m.begin : m.end, out = side == 0 ? -1 : 1;
  for (double on = step; on <= priors.drop_reach; on += step) {
    const double s = edge + out * on;
    if (2 * m.uncertainty(s) > widest_wire)
      break;
    double met = 0, ahead = 0;
    candidates.grid.forEachWithin(m.at(s), eaves, [&](Index i, double) {
      const double beyond = out * (m.along(candidates.points[i]) - edge);
      if (growth.owner(i) != Growth::nobody || beyond <= 0)
        return;
      met += 1;
      ahead += beyond;
    });
    if (met >= a_roof)
      return ahead / met;
  }
  return -1;
}

} // namespace

bool
addServiceDrops(std::vector<WireWithEnds>& wires,
                Growth& growth,
                const std::vector<Seed>& seeds,
                const std::vector<Curve>& curves,
                const Underside& underside,
                bool terrain,
                const PowerLineSettings& settings)
{
  const Candidates& candidates = growth.candidates();
  const std::vector<Stretch> lines = stretchesOf(wires, candidates);
  PowerLineSettings relaxed = settings;
  relaxed.min_length = std::min(least_seen, settings.min_length);
  const double shortest = std::min(priors.shortest_drop, settings.min_length);
  const std::size_t before = wires.size();
  const auto addIfDrop = [&](Piece& piece) {
    const SpanModel& m = piece.model;
    const double ways[2] = {wayTo(m, 0, lines), wayTo(m, 1, lines)};
    if ((ways[0] >= 0) == (ways[1] >= 0))
      return;
    const double home = wayHome(m, ways[0] >= 0 ? 1 : 0, growth);
    // A wire does not end in midair: if no house is seen, it is farther away.
    const double length =
        std::max(ways[0], ways[1]) + m.length() + (home < 0 ? priors.drop_reach : home);
    if (length < shortest || length > priors.longest_drop ||
        heightOf(piece, candidates) > priors.highest_pole)
      return;
    if (terrain && !isOpenBelow(m, underside))
      return;
    const Evidence evidence = weigh(growth, piece, relaxed);
    const Bend bend = bendOf(piece, candidates.points);
    if (!evidence.accepted || evidence.likelihood < priors.alone ||
        bend.rulesOut(flattest) ||
        (evidence.chord > priors.steepest_drop && !bend.isAbove(flattest)))
      return;
    growth.claim(piece, 0);
    WireWithEnds drop;
    drop.strand.piece = std::move(piece);
    drop.leaves = {ways[0] >= 0, ways[1] >= 0};
    wires.push_back(std::move(drop));
  };
  std::vector<char> tried(candidates.points.size(), 0);
  for (const Seed& seed : seeds) {
    const Point& p = candidates.points[seed.candidate];
    if (tried[seed.candidate] != 0 || growth.owner(seed.candidate) != Growth::nobody ||
        std::none_of(lines.begin(), lines.end(), [&](const Stretch& line) {
          const double s = std::clamp(line.wire->along(p), line.low, line.high);
          return (line.wire->at(s) - p).norm() < priors.longest_drop;
        }))
      continue;
    for (Piece& piece : growth.grow(seed)) {
      for (const Index i : piece.members)
        tried[i] = 1;
      addIfDrop(piece);
    }
  }
  // If clutter beside a drop spoils its seeds, its curve may still show it.
  forEachPieceAlong(curves, growth, settings.threads, addIfDrop);
  return wires.size() > before;
}

void
carryDropsHome(std::vector<WireWithEnds>& wires, const Growth& growth)
{
  for (WireWithEnds& wire : wires)
    for (int side = 0; side < 2; ++side) {
      End& end = wire.ends[static_cast<std::size_t>(side)];
      if (!wire.leaves[static_cast<std::size_t>(1 - side)] ||
          wire.leaves[static_cast<std::size_t>(side)] || end.fixed)
        continue;
      const SpanModel& m = wire.model();
      const double home = wayHome(m, side, growth);
      if (home < 0)
        continue;
      end.place = m.at(wire.edge(side) + (side == 0 ? -home : home));
      end.fixed = true;
    }
}

} // namespace linelet::powerline
