// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/pieces/parallel_wires.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "powerline/line_priors.h"
#include "powerline/pieces/candidates.h"
#include "powerline/pieces/evidence.h"
#include "powerline/pieces/growth.h"
#include "powerline/pieces/parallel.h"
#include "powerline/pieces/span_model.h"

namespace linelet::powerline {

namespace {

constexpr double source_length = 20;   // meters of a wire whose shape predicts others
constexpr double stretch = 4;          // meters along
constexpr double stretch_cover = 0.25; // of the stretches
constexpr int least_stretches = 4;
constexpr std::size_t most_tries = 16;
constexpr std::size_t crowded_meter = 200; // free points per meter, a wood
constexpr double off_middle = 0.1; // of its length, lowest point of a wire cut off
constexpr double sag_spread = 0.3; // sags of one line differ by this part, at most

constexpr double most_beside =
    0.5;                           // of the length of a wire, in the scatter of another
constexpr double whole = 0.7;      // of the length of the wire beside
constexpr double thin_cover = 0.2; // of the bins of a wire nearly as long ...
constexpr double thin_clean = 0.9; // ... of those with points, clean

/** Where wires are sought beside another, and how finely; meters. */
struct Zone {
  double from, to; ///< distances from it
  double cell;     ///< width of one place for a wire
  double beyond;   ///< the ends of the other, a wire may lead
};

// For wires of a line, and for those of a rack, which are resolved if they are farther
// apart than their points scatter.
constexpr Zone line = {0.35, 9, 0.3, std::numeric_limits<double>::infinity()};
constexpr double rack_cell = 2.5;   // standard deviations ...
constexpr double least_cell = 0.05; // ... or meters: wires of a rack do not hang alike

Zone
rackOf(const SpanModel& m)
{
  const double cell = std::max(least_cell, rack_cell * m.sigma);
  return {1.5 * cell, LinePriors().rack, cell, growth_gap};
}

/** A wire that hangs like another: beside it, and flatter or deeper. */
struct Place {
  Eigen::Vector2d offset; ///< to the left and upwards, at the pivot
  double bend;            ///< additional bend, relative to the other's
  double pivot;           ///< where on the other its tangent is the same

  SpanModel
  beside(const SpanModel& other) const
  {
    SpanModel m = other;
    const double more = bend * other.z[2];
    m.t[0] += offset[0];
    // more * (s - pivot)^2, expanded
    m.z += Eigen::Vector3d(offset[1] + more * pivot * pivot, -2 * more * pivot, more);
    return m;
  }
};

/** A free point near a wire, in its frame. */
struct BesideWire {
  int stretch;
  double s, left, up;
};

std::vector<BesideWire>
freePointsBeside(const Growth& growth, const SpanModel& m, const Zone& zone, int bins)
{
  const Candidates& candidates = growth.candidates();
  const double step = m.length() / bins;
  std::vector<BesideWire> points;
  for (int k = 0; k < bins; ++k) {
    const double from = m.begin + k * step;
    candidates.grid.forEachWithin(
        m.at(from + step / 2), std::hypot(step / 2, zone.to), [&](Index i, double) {
          const double s = m.along(candidates.points[i]);
          if (growth.owner(i) != Growth::nobody || s < from || s >= from + step)
            return;
          const Eigen::Vector2d r = m.residual(candidates.points[i], s);
          if (r.norm() >= zone.from && r.norm() <= zone.to)
            points.push_back({k, s, r[0], r[1]});
        });
    if (points.size() > crowded_meter * static_cast<std::size_t>(1 + m.length()))
      return {};
  }
  return points;
}

/** A place and the stretches that have points there. */
struct Found {
  int stretches;
  Place place;
};

// Places beside a wire with points along much of it, for wires whose tangent is that of
// the other at \a pivot.
void
findPlaces(const std::vector<BesideWire>& points,
           const SpanModel& m,
           const Zone& zone,
           int bins,
           double pivot,
           std::vector<Found>& found)
{
  const double farthest = std::max(m.end - pivot, pivot - m.begin);
  const double drop = std::abs(m.z[2]) * farthest * farthest;
  const double cell = zone.cell;
  const int bends = static_cast<int>(sag_spread * drop / cell);
  const int half = static_cast<int>(zone.to / cell) + 2, side = 2 * half + 1;
  struct Count {
    int stretches, last;
  };
  for (int bend = -bends; bend <= bends; ++bend) {
    const double part = bend * cell / std::max(drop, cell);
    std::vector<Count> counts(static_cast<std::size_t>(side * side), Count{0, -1});
    for (const BesideWire& p : points) {
      const double up = p.up - part * m.z[2] * std::pow(p.s - pivot, 2);
      // A place is four cells wide and shares them with its neighbors.
      const int x = static_cast<int>(std::floor(p.left / cell)) + half;
      const int y = static_cast<int>(std::floor(up / cell)) + half;
      if (y < 0 || y + 1 >= side)
        continue;
      for (const int at : {y * side + x, y * side + x + 1})
        for (Count* count : {&counts[static_cast<std::size_t>(at)],
                             &counts[static_cast<std::size_t>(at + side)]})
          if (count->last != p.stretch)
            *count = {count->stretches + 1, p.stretch}; // points are sorted by stretch
    }
    for (int at = 0; at < side * side; ++at)
      if (const int n = counts[static_cast<std::size_t>(at)].stretches;
          n >= least_stretches && n >= stretch_cover * bins)
        found.push_back(
            {n, {{(at % side - half) * cell, (at / side - half) * cell}, part, pivot}});
  }
}

// The best places beside a wire, one per wire.
std::vector<Place>
findPlaces(const Growth& growth, const SpanModel& m, const Zone& zone)
{
  const int bins = std::max(1, static_cast<int>(m.length() / stretch));
  const std::vector<BesideWire> points = freePointsBeside(growth, m, zone, bins);
  // Wires between the same supports differ least in the middle; where the data cut the
  // span off, its lowest point shows where that is.
  const double middle = (m.begin + m.end) / 2;
  const double vertex = m.z[2] > 0 ? -m.z[1] / (2 * m.z[2]) : middle;
  std::vector<Found> found;
  findPlaces(points, m, zone, bins, middle, found);
  if (vertex > m.begin && vertex < m.end &&
      std::abs(vertex - middle) > off_middle * m.length())
    findPlaces(points, m, zone, bins, vertex, found);
  std::stable_sort(found.begin(), found.end(), [](const Found& a, const Found& b) {
    return std::tuple(-a.stretches, std::abs(a.place.bend)) <
           std::tuple(-b.stretches, std::abs(b.place.bend));
  });
  std::vector<Place> places;
  for (const Found& f : found) {
    const SpanModel candidate = f.place.beside(m);
    if (places.size() < most_tries &&
        std::none_of(places.begin(), places.end(), [&](const Place& other) {
          return compare(candidate, other.beside(m)).distance < 1.5 * zone.cell;
        }))
      places.push_back(f.place);
  }
  return places;
}

// A wire that follows another over its whole length may have few points, if nothing
// else is near.
bool
isParallelWire(const Growth& growth,
               const Piece& piece,
               const SpanModel& source,
               const PowerLineSettings& settings)
{
  const Evidence e = weigh(growth, piece, settings);
  return e.likelihood >= priors.in_company &&
         (e.accepted ||
          (e.sound && piece.model.length() >= whole * source.length() &&
           e.occupied >= thin_cover * e.bins && e.clean >= thin_clean * e.occupied));
}

// Whether \a piece runs within the scatter of one of \a wires.
bool
isScatterOf(const std::vector<Piece>& wires, const Piece& piece)
{
  return std::any_of(wires.begin(), wires.end(), [&](const Piece& wire) {
    const Parallel parallel = compare(piece.model, wire.model);
    return parallel.overlap >= most_beside * piece.model.length() &&
           parallel.distance <= wire.tolerance();
  });
}

} // namespace

void
addParallelWires(Growth& growth,
                 std::vector<Piece>& pieces,
                 const PowerLineSettings& settings)
{
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < pieces.size(); ++i)
    if (pieces[i].model.length() >= source_length)
      order.push_back(i);
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return pieces[a].model.length() != pieces[b].model.length()
               ? pieces[a].model.length() > pieces[b].model.length()
               : a < b;
  });
  for (const std::size_t source : order)
    for (const Zone& zone : {rackOf(pieces[source].model), line})
      for (const Place& place : findPlaces(growth, pieces[source].model, zone)) {
        Piece parallel;
        parallel.model = place.beside(pieces[source].model);
        if (!growth.collect(parallel, zone.cell) ||
            !growth.collect(parallel, parallel.model.tolerance) ||
            !growth.extend(parallel,
                           pieces[source].model.begin - zone.beyond,
                           pieces[source].model.end + zone.beyond) ||
            !isParallelWire(growth, parallel, pieces[source].model, settings) ||
            isScatterOf(pieces, parallel))
          continue;
        growth.claim(parallel, static_cast<int>(pieces.size()));
        pieces.push_back(std::move(parallel));
      }
}

} // namespace linelet::powerline
