// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/pieces/vertical_slice.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "powerline/pieces/candidates.h"
#include "powerline/pieces/growth.h"
#include "powerline/pieces/span_model.h"

namespace linelet::powerline {

namespace {

constexpr double half_width = 1.25; // meters beside the wire
constexpr double patch = 2;         // meters, of the vertical slice examined at once
constexpr double filled = 0.7; // of the meters from the lowest candidates to the wire
constexpr double contrast = 4; // points of the pole per points around
constexpr double alone_from = 0.6, alone_to = 3.0; // meters, empty around a pole ...
constexpr double filled_alone = 0.4;               // ... that may fill so little
constexpr std::size_t crowded_slice =
    3000; // points below, too many for a pole in the open

} // namespace

double
heightOf(const Piece& wire, const Candidates& candidates)
{
  const Indices& members = wire.members;
  double height = 0;
  for (const Index i : members)
    height += static_cast<double>(candidates.height[i]);
  return height / static_cast<double>(members.size());
}

std::vector<Below>
verticalSliceOf(const Piece& wire, const Growth& growth)
{
  const SpanModel& m = wire.model;
  const double height = heightOf(wire, growth.candidates()) + patch;
  std::vector<Below> points;
  const Candidates& candidates = growth.candidates();
  for (double s = m.begin; s < m.end; s += patch)
    for (double drop = -level; drop < height; drop += patch) {
      const Point center = m.at(s + patch / 2) - (drop + patch / 2) * Point::UnitZ();
      candidates.grid.forEachWithin(
          center, std::hypot(patch, half_width), [&](Index i, double) {
            const Point& p = candidates.points[i];
            const double at = m.along(p);
            if (growth.owner(i) != Growth::nobody || at < s || at >= s + patch)
              return;
            const Eigen::Vector2d r = m.residual(p, at);
            const double below = m.height(at) - p.z();
            if (std::abs(r[0]) <= half_width && below >= drop && below < drop + patch)
              points.push_back({at,
                                r[0],
                                below,
                                below + static_cast<double>(candidates.height[i]) -
                                    candidates.least_height});
          });
    }
  return points;
}

std::vector<double>
findColumns(const std::vector<Below>& vertical_slice)
{
  std::vector<double> found;
  if (vertical_slice.size() > crowded_slice)
    return found;
  std::vector<Below> points = vertical_slice;
  std::sort(points.begin(), points.end(), [](const Below& a, const Below& b) {
    return a.s < b.s;
  });
  struct Pole {
    double s, inside;
  };
  std::vector<Pole> poles;
  auto first = points.cbegin(); // of those close enough to matter
  for (const Below& center : points) {
    while (center.s - first->s > alone_to)
      ++first;
    const int slices = static_cast<int>(std::floor(center.depth - 0.3));
    if (slices < 2)
      continue;
    std::set<int> hit;
    double inside = 0, around = 0;
    bool alone = true;
    for (auto p = first; p != points.cend() && p->s - center.s <= alone_to; ++p) {
      if (p->drop < 0.3 || p->drop > center.depth)
        continue;
      const double away = std::abs(p->s - center.s);
      if (away <= pole_radius && std::hypot(away, p->t - center.t) <= pole_radius) {
        ++inside;
        hit.insert(static_cast<int>(p->drop - 0.3));
      }
      else if (away >= clear_from && away <= clear_to)
        ++around;
      alone = alone && (away < alone_from || away > alone_to);
    }
    const double least = alone ? filled_alone : filled;
    if (static_cast<double>(hit.size()) >= least * slices && *hit.begin() <= 1 &&
        inside >= (alone ? 3 : 4) && inside >= contrast * around)
      poles.push_back({center.s, inside});
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

} // namespace linelet::powerline
