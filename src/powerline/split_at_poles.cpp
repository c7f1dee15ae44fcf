// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <set>

#include "powerline/joints.h"

namespace linelet::powerline {

namespace {

constexpr double highest_pole = 16; // metres of a wire above ground
constexpr double curtain = 1.25;    // metres beside the wire
constexpr double patch = 2;         // metres, of the curtain looked at at once
constexpr double pole_radius = 0.4; // metres
constexpr double clear_from = 0.9, clear_to = 2.0; // metres around it, along the wire
constexpr double filled = 0.7; // of the metres from candidates to wire
constexpr double contrast = 4; // points of the pole per points around
constexpr double alone_from = 0.6, alone_to = 3.0; // metres, empty around a pole ...
constexpr double filled_alone = 0.4;               // ... that may fill so little
constexpr double least_piece = 6;                  // metres, a shorter rest is cut off
constexpr std::size_t crowded = 3000; // points below, too many for a pole in the open

struct Below {
  double s, t, drop; // along, across, below the wire
  double depth;      // of the lowest candidate that there can be
};

// The free candidates in the curtain below a wire.
std::vector<Below>
curtainOf(const SpanModel& m, const Growth& growth, double height)
{
  std::vector<Below> points;
  const Candidates& candidates = growth.candidates();
  for (double s = m.begin; s < m.end; s += patch)
    for (double drop = 0; drop < height; drop += patch) {
      const Point centre = m.at(s + patch / 2) - (drop + patch / 2) * Point::UnitZ();
      candidates.grid.forEachWithin(
          centre, std::hypot(patch, curtain), [&](Index i, double) {
            const Point& p = candidates.points[i];
            const double at = m.along(p);
            if (growth.owner(i) != Growth::nobody || at < s || at >= s + patch)
              return;
            const Eigen::Vector2d r = m.residual(p, at);
            const double below = SpanModel::value(m.z, at) - p.z();
            if (std::abs(r[0]) <= curtain && below >= drop && below < drop + patch)
              points.push_back({at,
                                r[0],
                                below,
                                below + static_cast<double>(candidates.height[i]) -
                                    candidates.least_height});
          });
    }
  return points;
}

// Where a pole stands below a wire, with nothing much beside it.
std::vector<double>
findPoles(const std::vector<Below>& points)
{
  std::vector<double> found;
  if (points.size() > crowded)
    return found;
  struct Pole {
    double s, inside;
  };
  std::vector<Pole> poles;
  for (const Below& centre : points) {
    const int slices = static_cast<int>(std::floor(centre.depth - 0.3));
    if (slices < 2)
      continue;
    std::set<int> hit;
    double inside = 0, around = 0;
    bool alone = true;
    for (const Below& p : points) {
      if (p.drop < 0.3 || p.drop > centre.depth)
        continue;
      const double away = std::abs(p.s - centre.s);
      if (std::hypot(p.s - centre.s, p.t - centre.t) <= pole_radius) {
        ++inside;
        hit.insert(static_cast<int>(p.drop - 0.3));
      }
      else if (away >= clear_from && away <= clear_to)
        ++around;
      alone = alone && (away < alone_from || away > alone_to);
    }
    const double least = alone ? filled_alone : filled;
    if (static_cast<double>(hit.size()) >= least * slices && *hit.begin() <= 1 &&
        inside >= (alone ? 3 : 4) && inside >= contrast * around)
      poles.push_back({centre.s, inside});
  }
  std::sort(poles.begin(), poles.end(), [](const Pole& a, const Pole& b) {
    return a.inside != b.inside ? a.inside > b.inside : a.s < b.s;
  });
  for (const Pole& pole : poles)
    if (std::none_of(found.begin(), found.end(), [&](double s) {
          return std::abs(s - pole.s) < least_piece;
        }))
      found.push_back(pole.s);
  std::sort(found.begin(), found.end());
  return found;
}

} // namespace

void
splitAtPoles(std::vector<Hanging>& wires, Growth& growth)
{
  const Candidates& candidates = growth.candidates();
  std::vector<Hanging> result;
  for (Hanging& wire : wires) {
    Piece& piece = wire.strand.piece;
    double height = 0;
    for (const Index i : piece.members)
      height += static_cast<double>(candidates.height[i]) /
                static_cast<double>(piece.members.size());
    std::vector<double> poles;
    if (height < highest_pole)
      poles = findPoles(curtainOf(piece.model, growth, height + patch));
    if (poles.empty()) {
      result.push_back(std::move(wire));
      continue;
    }
    growth.claim(piece, Growth::nobody);
    for (std::size_t k = 0; k <= poles.size(); ++k) {
      const double low = k == 0 ? piece.model.begin : poles[k - 1];
      const double high = k == poles.size() ? piece.model.end : poles[k];
      if (high - low < least_piece)
        continue;
      Hanging part;
      for (const Index i : piece.members) {
        const double s = piece.model.along(candidates.points[i]);
        if (s >= low && s <= high)
          part.strand.piece.members.push_back(i);
      }
      part.strand.piece.model = piece.model;
      SpanModel& m = part.strand.piece.model;
      m.begin = low;
      m.end = high;
      m = m.reframed();
      if (!fit(m, candidates.points, part.strand.piece.members))
        continue;
      growth.claim(part.strand.piece, 0);
      result.push_back(std::move(part));
    }
    if (!result.empty())
      for (Piece& companion : wire.strand.companions)
        result.back().strand.companions.push_back(std::move(companion));
  }
  wires = std::move(result);
}

} // namespace linelet::powerline
