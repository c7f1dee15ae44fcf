// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/spans/spans_between.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "powerline/line_priors.h"
#include "powerline/pieces/counts.h"
#include "powerline/pieces/data_border.h"
#include "powerline/pieces/evidence.h"
#include "powerline/pieces/parallel.h"
#include "powerline/pieces/span_model.h"

namespace linelet::powerline {

namespace {

constexpr double shortest = 15;      // meters; less is a hidden stretch, not a span
constexpr double least_cosine = 0.8; // between a wire and the direction to the next
constexpr double steepest = 0.35;    // slope of that direction
constexpr double tube = 0.3;         // meters around a place to try
constexpr double tension_spread = 2; // ratio of bends along a line, at most
constexpr double end_reach = 0.5;    // meters from the ends of the wires beside it

/** An end of a wire without a continuation. */
struct FreeEnd {
  std::size_t wire;
  int side;
  Point place;
};

/** A wire that may hang between two free ends. */
struct Between {
  std::size_t from = 0, to = 0; // free ends
  SpanModel model;
  double evidence = 0;
};

std::vector<FreeEnd>
freeEnds(const std::vector<WireWithEnds>& wires, const Underside& underside)
{
  std::vector<FreeEnd> all;
  for (std::size_t w = 0; w < wires.size(); ++w)
    for (int side = 0; side < 2; ++side)
      if (wires[w].ends[static_cast<std::size_t>(side)].partner < 0 &&
          wires[w].strand.piece.thickness == 0 &&
          wires[w].model().length() >= priors.short_line &&
          !leavesData(wires[w].model(), side, underside))
        all.push_back({w, side, wires[w].model().at(wires[w].edge(side))});
  return all;
}

// The wire with \a bend from one place to another.
SpanModel
hung(const Point& from, const Point& to, double bend)
{
  SpanModel m;
  const double length = (to - from).head<2>().norm();
  m.origin = from.head<2>();
  m.direction = (to - from).head<2>() / length;
  m.z = {from.z(), (to.z() - from.z()) / length - bend * length, bend};
  m.end = length;
  m.tolerance = tube;
  return m;
}

double
evidenceOf(const Growth& growth, const SpanModel& m, double density)
{
  double evidence = 0;
  const double larger = ring_radius * ring_radius / (tube * tube) - 1;
  for (double s = m.begin; s < m.end; s += bin_length) {
    const Bin bin = growth.look(m, s, std::min(s + bin_length, m.end), tube);
    evidence +=
        logWire({static_cast<double>(bin.tube), static_cast<double>(bin.ring), larger},
                density,
                priors.hidden);
  }
  return evidence;
}

double
densityOf(const Piece& piece)
{
  return bin_length * static_cast<double>(piece.members.size()) /
         std::max(bin_length, piece.model.length());
}

// The wire with the most evidence between two ends.
Between
mostEvident(const Growth& growth,
            const WireWithEnds& a,
            const WireWithEnds& b,
            Between between,
            const FreeEnd& from,
            const FreeEnd& to)
{
  const double length = (to.place - from.place).head<2>().norm();
  const double density = (densityOf(a.strand.piece) + densityOf(b.strand.piece)) / 2;
  const double least = std::min(a.model().z[2], b.model().z[2]) / tension_spread;
  const double most = std::max(a.model().z[2], b.model().z[2]) * tension_spread;
  const double step = 4 * tube / (length * length); // of the sag: the tube's radius
  for (double bend = std::max(least, priors.leastBend(length)); bend <= most + step;
       bend += step) {
    SpanModel m = hung(from.place, to.place, bend);
    const double evidence = evidenceOf(growth, m, density);
    if (evidence <= between.evidence)
      continue;
    between.evidence = evidence;
    between.model = m;
  }
  return between;
}

bool
mayHang(const WireWithEnds& a,
        const WireWithEnds& b,
        const FreeEnd& from,
        const FreeEnd& to)
{
  const Point way = to.place - from.place;
  const double length = way.head<2>().norm();
  return length >= shortest &&
         length <= priors.longer * std::max(a.model().length(), b.model().length()) &&
         std::abs(way.z()) <= steepest * length &&
         a.outward(from.side).dot(way.head<2>()) >= least_cosine * length &&
         b.outward(to.side).dot(way.head<2>()) <= -least_cosine * length;
}

// The wire that the points show there; without members if they show none.
Piece
seenAt(const Growth& growth, const Between& between, const PowerLineSettings& settings)
{
  Piece piece;
  piece.model = between.model;
  const Point from = between.model.at(between.model.begin),
              to = between.model.at(between.model.end);
  if (!growth.collect(piece, tube) || !growth.collect(piece, piece.tolerance()))
    return {};
  for (const Point& end : {from, to})
    if (piece.model.distance(end) >
        end_reach + priors.spread * piece.model.uncertainty(piece.model.along(end)))
      return {};
  const Evidence evidence = weigh(growth, piece, settings);
  if (!evidence.hangs || evidence.likelihood < priors.in_company)
    return {};
  piece.model = piece.model.reframed();
  return piece;
}

} // namespace

bool
addSpansBetween(std::vector<WireWithEnds>& wires,
                Growth& growth,
                const Underside& underside,
                const PowerLineSettings& settings)
{
  const std::vector<FreeEnd> ends = freeEnds(wires, underside);
  std::vector<Between> all;
  for (std::size_t i = 0; i < ends.size(); ++i)
    for (std::size_t k = i + 1; k < ends.size(); ++k) {
      const WireWithEnds &a = wires[ends[i].wire], &b = wires[ends[k].wire];
      if (ends[i].wire == ends[k].wire || !mayHang(a, b, ends[i], ends[k]))
        continue;
      Between between;
      between.from = i;
      between.to = k;
      between = mostEvident(growth, a, b, between, ends[i], ends[k]);
      if (between.evidence > 0)
        all.push_back(between);
    }
  std::sort(all.begin(), all.end(), [](const Between& a, const Between& b) {
    return std::tuple(-a.evidence, a.from, a.to) <
           std::tuple(-b.evidence, b.from, b.to);
  });
  std::vector<char> used(ends.size(), 0);
  const std::size_t before = wires.size();
  for (const Between& between : all) {
    if (used[between.from] != 0 || used[between.to] != 0)
      continue;
    Piece piece = seenAt(growth, between, settings);
    if (piece.members.empty())
      continue;
    used[between.from] = used[between.to] = 1;
    growth.claim(piece, 0);
    WireWithEnds wire;
    wire.strand.piece = std::move(piece);
    wires.push_back(std::move(wire));
  }
  return wires.size() > before;
}

namespace {

constexpr double level_with = 12; // meters along the line between ends
constexpr double turned = 0.04;   // radians that a wire may differ from those beside
constexpr double turn_step = 0.01;
constexpr double apart = 0.3; // meters, from other wires

// Wires that hang like \a next, moved by \a offset at \a from, one of its ends; those
// with the most evidence first.
std::vector<SpanModel>
movedBeside(const Growth& growth,
            const WireWithEnds& next,
            int from,
            const Point& offset,
            double density)
{
  const SpanModel& m = next.model();
  std::vector<std::pair<double, SpanModel>> tried;
  for (double turn = -turned; turn <= turned; turn += turn_step)
    for (double rise = -turned; rise <= turned; rise += turn_step) {
      SpanModel moved = m;
      const double pivot = next.edge(from);
      moved.origin += offset.head<2>();
      moved.z[0] += offset.z() - rise * pivot;
      moved.z[1] += rise;
      moved.t[0] -= turn * pivot;
      moved.t[1] += turn;
      moved.tolerance = tube;
      const double evidence = evidenceOf(growth, moved, density);
      if (evidence > 0)
        tried.emplace_back(evidence, moved);
    }
  std::stable_sort(tried.begin(), tried.end(), [](const auto& a, const auto& b) {
    return a.first > b.first;
  });
  std::vector<SpanModel> best;
  for (std::size_t i = 0; i < tried.size() && i < 2; ++i)
    best.push_back(tried[i].second);
  return best;
}

// Whether \a m runs into a wire.
bool
isTaken(const SpanModel& m, const std::vector<WireWithEnds>& wires)
{
  return std::any_of(wires.begin(), wires.end(), [&](const WireWithEnds& wire) {
    const Parallel parallel = compare(m, wire.model());
    return parallel.overlap > 0.3 * m.length() && parallel.distance < apart;
  });
}

} // namespace

bool
addSpansBeside(std::vector<WireWithEnds>& wires,
               Growth& growth,
               const Underside& underside,
               const PowerLineSettings& settings)
{
  const std::size_t before = wires.size();
  for (const FreeEnd& end : freeEnds(wires, underside)) {
    Piece best;
    double most = priors.in_company;
    for (std::size_t x = 0; x < before; ++x)
      for (int side = 0; side < 2; ++side) {
        const WireWithEnds &wire = wires[end.wire], &other = wires[x];
        const End& held = other.ends[static_cast<std::size_t>(side)];
        if (x == end.wire || held.partner < 0 ||
            static_cast<std::size_t>(held.partner) >= before ||
            other.outward(side).dot(wire.outward(end.side)) < 0.98)
          continue;
        const SpanModel& m = wire.model();
        const double s = m.along(held.place);
        const Point offset = m.at(s) - held.place;
        if (offset.norm() > priors.company_reach ||
            std::abs(s - wire.edge(end.side)) > level_with ||
            2 * m.uncertainty(s) > 2 * tube)
          continue;
        const WireWithEnds& next = wires[static_cast<std::size_t>(held.partner)];
        if (next.strand.piece.thickness > 0)
          continue;
        const double density =
            (densityOf(wire.strand.piece) + densityOf(next.strand.piece)) / 2;
        for (const SpanModel& moved :
             movedBeside(growth, next, held.partner_side, offset, density)) {
          Between between;
          between.model = moved;
          Piece piece = seenAt(growth, between, settings);
          if (piece.members.empty() || isTaken(piece.model, wires))
            continue;
          const double likelihood = weigh(growth, piece, settings).likelihood;
          if (likelihood <= most)
            continue;
          most = likelihood;
          best = std::move(piece);
        }
      }
    if (best.members.empty())
      continue;
    growth.claim(best, 0);
    WireWithEnds wire;
    wire.strand.piece = std::move(best);
    wires.push_back(std::move(wire));
  }
  return wires.size() > before;
}

} // namespace linelet::powerline
