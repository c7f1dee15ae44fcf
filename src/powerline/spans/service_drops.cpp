// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/spans/service_drops.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "powerline/line_priors.h"
#include "powerline/pieces/bend.h"
#include "powerline/pieces/candidates.h"
#include "powerline/pieces/evidence.h"
#include "powerline/pieces/growth.h"
#include "powerline/pieces/open_below.h"
#include "powerline/pieces/span_model.h"
#include "powerline/pieces/vertical_slice.h"
#include "powerline/spans/wire_with_ends.h"

namespace linelet::powerline {

namespace {

constexpr LinePriors priors;
constexpr double least_seen = 4; // meters of a drop that show
constexpr double own_way = 0.95; // cosine to its line, at most
constexpr double step = 0.25;    // meters, on the way to a house
constexpr double eaves = 1;      // meters around the end of a drop, of its house ...
constexpr double a_roof = 3;     // ... points there

/** Where a low line hangs from a support. */
struct Attachment {
  Point place;
  Eigen::Vector2d along; ///< its wire there
};

std::vector<Attachment>
attachmentsOf(const std::vector<WireWithEnds>& wires, const Candidates& candidates)
{
  std::vector<Attachment> all;
  for (const WireWithEnds& wire : wires) {
    if (wire.leaves[0] || wire.leaves[1] || wire.strand.piece.thickness > 0 ||
        heightOf(wire.strand.piece, candidates) > priors.highest_pole)
      continue;
    for (const End& end : wire.ends)
      if (end.partner >= 0 || wire.model().length() >= priors.short_line)
        all.push_back({end.place, wire.model().direction});
  }
  return all;
}

// Meters from the end of \a m on to where it hangs from one of \a attachments; negative
// where it does not.
double
wayTo(const SpanModel& m, int side, const std::vector<Attachment>& attachments)
{
  double nearest = -1;
  for (const Attachment& from : attachments) {
    const double s = m.along(from.place);
    const double on = side == 0 ? m.begin - s : s - m.end;
    if (on < -1 || on > priors.drop_reach || (nearest >= 0 && on >= nearest) ||
        std::abs(m.direction.dot(from.along)) > own_way)
      continue;
    const Point offset = m.at(s) - from.place;
    if (offset.head<2>().norm() <= priors.drop_beside &&
        offset.z() >= -priors.drop_below && offset.z() <= priors.drop_beside)
      nearest = std::max(0.0, on);
  }
  return nearest;
}

// Meters from the end of \a m on to the house that it leads to; negative where none is
// met as long as it is certain where the wire would hang.
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
                const Underside& underside,
                bool terrain,
                const PowerLineSettings& settings)
{
  const Candidates& candidates = growth.candidates();
  const std::vector<Attachment> attachments = attachmentsOf(wires, candidates);
  PowerLineSettings relaxed = settings;
  relaxed.min_length = std::min(least_seen, settings.min_length);
  const double shortest = std::min(priors.shortest_drop, settings.min_length);
  std::vector<char> tried(candidates.points.size(), 0);
  const std::size_t before = wires.size();
  for (const Seed& seed : seeds) {
    const Point& p = candidates.points[seed.candidate];
    if (tried[seed.candidate] != 0 || growth.owner(seed.candidate) != Growth::nobody ||
        std::none_of(attachments.begin(), attachments.end(), [&](const Attachment& a) {
          return (a.place - p).norm() < priors.longest_drop;
        }))
      continue;
    for (Piece& piece : growth.grow(seed)) {
      for (const Index i : piece.members)
        tried[i] = 1;
      const SpanModel& m = piece.model;
      const double ways[2] = {wayTo(m, 0, attachments), wayTo(m, 1, attachments)};
      if ((ways[0] >= 0) == (ways[1] >= 0))
        continue;
      const double home = wayHome(m, ways[0] >= 0 ? 1 : 0, growth);
      // A wire does not end in the air: where no house is seen, it is farther.
      const double length = std::max(ways[0], ways[1]) + m.length() +
                            (home < 0 ? priors.drop_reach : home);
      if (length < shortest || length > priors.longest_drop)
        continue;
      if (terrain && !isOpenBelow(m, underside))
        continue;
      const Evidence evidence = weigh(growth, piece, relaxed);
      const Bend bend = bendOf(piece, candidates.points);
      if (!evidence.accepted || evidence.likelihood < priors.alone ||
          bend.rulesOut(flattest) ||
          (evidence.chord > priors.steepest_drop && !bend.isAbove(flattest)))
        continue;
      growth.claim(piece, 0);
      WireWithEnds drop;
      drop.strand.piece = std::move(piece);
      drop.leaves = {ways[0] >= 0, ways[1] >= 0};
      wires.push_back(std::move(drop));
    }
  }
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
