// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "powerline/evidence.h"
#include "powerline/merge.h"

namespace linelet::powerline {

namespace {

constexpr double source_length = 20; // metres of a wire whose shape tells of others
constexpr double reach = 9;          // metres to the next wire of a line
constexpr double too_near = 0.35;    // metres, from its own
constexpr double cell = 0.3;         // metres across, of one place for a wire
constexpr double stretch = 4;        // metres along
constexpr double least_cover = 0.25; // of the stretches
constexpr int least_stretches = 4;
constexpr std::size_t most_tries = 16;
constexpr std::size_t crowded = 200; // free points a metre, a wood

using Place = std::pair<int, int>; // across and upwards, in cells

// Places beside a wire where points stand along much of it, best first.
std::vector<Eigen::Vector2d>
findPlaces(const Growth& growth, const SpanModel& m)
{
  const Candidates& candidates = growth.candidates();
  const int bins = std::max(1, static_cast<int>(m.length() / stretch));
  const double step = m.length() / bins;
  std::map<Place, std::set<int>> stretches;
  std::size_t free = 0;
  for (int k = 0; k < bins; ++k) {
    const double from = m.begin + k * step;
    candidates.grid.forEachWithin(
        m.at(from + step / 2), std::hypot(step / 2, reach), [&](Index i, double) {
          const double s = m.along(candidates.points[i]);
          if (growth.owner(i) != Growth::nobody || s < from || s >= from + step)
            return;
          const Eigen::Vector2d r = m.residual(candidates.points[i], s);
          if (r.norm() < too_near || r.norm() > reach)
            return;
          ++free;
          // A place is four cells wide and shares them with its neighbours.
          const int x = static_cast<int>(std::floor(r[0] / cell));
          const int y = static_cast<int>(std::floor(r[1] / cell));
          for (int dx = 0; dx < 2; ++dx)
            for (int dy = 0; dy < 2; ++dy)
              stretches[{x + dx, y + dy}].insert(k);
        });
    if (free > crowded * static_cast<std::size_t>(1 + m.length()))
      return {};
  }
  std::vector<std::pair<int, Place>> sorted;
  for (const auto& [place, hit] : stretches)
    if (static_cast<int>(hit.size()) >= least_stretches &&
        static_cast<double>(hit.size()) >= least_cover * bins)
      sorted.emplace_back(-static_cast<int>(hit.size()), place);
  std::sort(sorted.begin(), sorted.end());
  std::vector<Eigen::Vector2d> places;
  for (const auto& [count, place] : sorted) {
    const Eigen::Vector2d centre(place.first * cell, place.second * cell);
    if (places.size() < most_tries &&
        std::none_of(places.begin(), places.end(), [&](const Eigen::Vector2d& other) {
          return (other - centre).lpNorm<Eigen::Infinity>() < 1.5 * cell;
        }))
      places.push_back(centre);
  }
  return places;
}

} // namespace

void
addSiblings(Growth& growth,
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
    for (const Eigen::Vector2d& place : findPlaces(growth, pieces[source].model)) {
      Piece sibling;
      sibling.model = pieces[source].model;
      sibling.model.t[0] += place[0];
      sibling.model.z[0] += place[1];
      if (!growth.collect(sibling, cell) ||
          !growth.collect(sibling, sibling.model.tolerance) ||
          !growth.extend(sibling) || !weigh(growth, sibling, settings).accepted)
        continue;
      growth.claim(sibling, static_cast<int>(pieces.size()));
      pieces.push_back(std::move(sibling));
    }
}

} // namespace linelet::powerline
