// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/spans/mend_breaks.h"

#include <algorithm>
#include <cmath>

#include "powerline/pieces/evidence.h"
#include "powerline/pieces/growth.h"
#include "powerline/pieces/kinks.h"
#include "powerline/pieces/span_model.h"
#include "powerline/spans/wire_with_ends.h"

namespace linelet::powerline {

namespace {

constexpr double near_by = 9;           // meters between wires of one line
constexpr double same_way = 0.98;       // cosine between their directions
constexpr double well_past = 10;        // meters that a wire continues beyond a place
constexpr std::size_t least_others = 3; // wires that a line has besides those that end
constexpr double mended_part = 0.9;     // of the points of both
constexpr double wide_cut = 2, narrow_cut = 0.6; // meters, fits of two parts

bool
runsPast(const SpanModel& m, const Point& place, const Eigen::Vector2d& along)
{
  const double s = m.along(place);
  return std::abs(m.direction.dot(along)) >= same_way && s - m.begin >= well_past &&
         m.end - s >= well_past && m.distance(place) <= near_by;
}

// One wire, or a bundle whose parts follow different conductors.
bool
joinParts(const Growth& growth,
          const Piece& a,
          const Piece& b,
          const PowerLineSettings& settings,
          Piece& joined)
{
  const Points& points = growth.candidates().points;
  const Piece& longer = a.model.length() >= b.model.length() ? a : b;
  const SpanModel& other = (&longer == &a ? b : a).model;
  joined.model = longer.model;
  joined.thickness = bundle_radius;
  joined.members = a.members;
  joined.members.insert(joined.members.end(), b.members.begin(), b.members.end());
  SpanModel& m = joined.model;
  if (!fit(m, points, joined.members, wide_cut) ||
      !fit(m, points, joined.members, narrow_cut))
    return false;
  const double from = m.along(other.at(other.begin)), to = m.along(other.at(other.end));
  m.begin = std::min({m.begin, from, to});
  m.end = std::max({m.end, from, to});
  m = m.reframed();
  const std::size_t before = joined.members.size();
  return growth.collect(joined, bundle_radius) &&
         static_cast<double>(joined.members.size()) >=
             mended_part * static_cast<double>(before) &&
         weigh(growth, joined, settings).sound && findKinks(joined, points).empty();
}

} // namespace

bool
isPassedBy(const std::vector<WireWithEnds>& wires,
           const Point& place,
           const Eigen::Vector2d& along,
           std::size_t ending)
{
  const auto others = static_cast<std::size_t>(
      std::count_if(wires.begin(), wires.end(), [&](const WireWithEnds& wire) {
        return runsPast(wire.model(), place, along);
      }));
  return others >= least_others && others > ending;
}

bool
mendBreaks(std::vector<WireWithEnds>& wires,
           Growth& growth,
           const PowerLineSettings& settings)
{
  std::vector<WireWithEnds> kept;
  std::vector<char> taken(wires.size(), 0);
  for (std::size_t w = 0; w < wires.size(); ++w) {
    WireWithEnds& wire = wires[w];
    for (int side = 0; side < 2; ++side) {
      const End& end = wire.ends[static_cast<std::size_t>(side)];
      const auto next = static_cast<std::size_t>(end.partner);
      if (end.partner < 0 || next <= w || taken[w] != 0 || taken[next] != 0 ||
          !isPassedBy(wires, end.place, wire.outward(side), 2))
        continue;
      Piece& a = wire.strand.piece;
      const Piece& b = wires[next].strand.piece;
      growth.claim(a, Growth::nobody);
      growth.claim(b, Growth::nobody);
      Piece joined;
      if (joinParts(growth, a, b, settings, joined)) {
        a = std::move(joined);
        for (Piece& companion : wires[next].strand.companions)
          wire.strand.companions.push_back(std::move(companion));
        taken[next] = 1;
      }
      else
        growth.claim(b, 0);
      growth.claim(a, 0);
    }
  }
  for (std::size_t w = 0; w < wires.size(); ++w)
    if (taken[w] == 0)
      kept.push_back(std::move(wires[w]));
  const bool any = kept.size() < wires.size();
  wires = std::move(kept);
  return any;
}

} // namespace linelet::powerline
