// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <unordered_map>

#include "powerline/describe.h"

namespace linelet::powerline {

namespace {

constexpr double widest_tube = 0.3; // metres
constexpr double tube_part = 1.25;  // of the tolerance of a wire
// Metres of a wire's end that are given to its support: fittings, and where the line
// turns the insulators, which then lie in line with the wire (longer ones at sharper
// turns).
constexpr double fittings = 1, strain_rate = 0.28, longest_strain = 4.5;
constexpr double tension_angle =
    10;                    // degrees; a line that turns less hangs below its arms
constexpr double foot = 2; // metres above ground, below is grass
constexpr double bundle_reach =
    0.6; // metres from one conductor of a bundle to the next
constexpr double least_companion = 4;  // points
constexpr double companion_part = 0.3; // of the points of the conductor that was found
constexpr double plan_cell = 16;       // metres

struct Best {
  float distance = std::numeric_limits<float>::infinity();
  std::int32_t wire = 0;
};

// Offers every candidate in the tube around a model to a wire.
template <class Distance>
void
offer(std::vector<Best>& best,
      const Candidates& candidates,
      const SpanModel& model,
      double from,
      double to,
      double reach,
      int wire,
      Distance&& distance)
{
  const int steps = std::max(1, static_cast<int>(std::ceil((to - from) / bin_length)));
  const double step = (to - from) / steps;
  for (int k = 0; k < steps; ++k) {
    const double begin = from + k * step, end = begin + step;
    const double rise = step * std::abs(SpanModel::slope(model.z, begin + step / 2));
    candidates.grid.forEachWithin(model.at(begin + step / 2),
                                  std::hypot(step, rise) / 2 + 2 * reach,
                                  [&](Index i, double) {
                                    const double s = model.along(candidates.points[i]);
                                    if (s < begin || s > end)
                                      return;
                                    const float d = static_cast<float>(
                                        distance(candidates.points[i]));
                                    if (d <= reach && d < best[i].distance)
                                      best[i] = {d, wire};
                                  });
  }
}

// Whether points beside a wire, outside its tube, are another conductor of its bundle
// that did not get a vector: they stand out from what is farther away.
bool
hasCompanion(const Growth& growth, const Piece& piece, double reach)
{
  const SpanModel& m = piece.model;
  double beside = 0, around = 0;
  const auto steps = static_cast<int>(std::ceil(m.length() / bin_length));
  for (int k = 0; k < steps; ++k) {
    const double from = m.begin + k * bin_length;
    const double inner =
        static_cast<double>(growth.look(m, from, from + bin_length, reach).tube);
    const double bundle =
        static_cast<double>(growth.look(m, from, from + bin_length, bundle_reach).tube);
    const double wide = static_cast<double>(
        growth.look(m, from, from + bin_length, 2 * bundle_reach).tube);
    beside += bundle - inner;
    around += wide - bundle;
  }
  const double expected = around * (1 - std::pow(reach / bundle_reach, 2)) / 3;
  return beside >= least_companion &&
         beside >= companion_part * static_cast<double>(piece.members.size()) &&
         beside > expected + 3 * std::sqrt(expected);
}

double
endPart(const Tower& tower)
{
  const double fitting = tower.pole ? 0.3 : fittings;
  return std::clamp(
      fitting + strain_rate * (tower.turn - tension_angle), fitting, longest_strain);
}

// Whether a point of a wire is so near its end that it belongs to the support there.
bool
endsAt(const Wire& wire, const Point& p, const std::vector<Tower>& towers, int support)
{
  const Tower& tower = towers[static_cast<std::size_t>(support)];
  const auto within = [&](int id, const Point& end) {
    return id == support + 1 && tower.seen &&
           (p - end).head<2>().norm() <= endPart(tower);
  };
  return within(wire.front_support, wire.front) || within(wire.back_support, wire.back);
}

class TowerIndex {
public:
  explicit TowerIndex(const std::vector<Tower>& towers)
  {
    for (std::size_t t = 0; t < towers.size(); ++t) {
      const double r = std::max(towers[t].reach + 2, 10.0);
      const Eigen::Vector2d& c = towers[t].arm.centre;
      for (double x = std::floor((c.x() - r) / plan_cell); x <= (c.x() + r) / plan_cell;
           ++x)
        for (double y = std::floor((c.y() - r) / plan_cell);
             y <= (c.y() + r) / plan_cell;
             ++y)
          cells_[{static_cast<std::int64_t>(x), static_cast<std::int64_t>(y)}]
              .push_back(t);
    }
  }

  const std::vector<std::size_t>*
  near(const Point& p) const
  {
    const auto cell =
        cells_.find({static_cast<std::int64_t>(std::floor(p.x() / plan_cell)),
                     static_cast<std::int64_t>(std::floor(p.y() / plan_cell))});
    return cell == cells_.end() ? nullptr : &cell->second;
  }

private:
  std::map<std::pair<std::int64_t, std::int64_t>, std::vector<std::size_t>> cells_;
};

} // namespace

void
labelPoints(PowerLineNetwork& network,
            const Points& points,
            const std::vector<Hanging>& hanging,
            const std::vector<int>& ids,
            const std::vector<Tower>& towers,
            const Growth& growth)
{
  const Candidates& candidates = growth.candidates();
  const double infinity = std::numeric_limits<double>::infinity();
  std::vector<Best> best(candidates.points.size());
  for (std::size_t w = 0; w < hanging.size(); ++w) {
    const Wire& wire = network.wires[static_cast<std::size_t>(ids[w] - 1)];
    const SpanModel& m = hanging[w].model();
    const double reach = std::max(std::min(widest_tube, tube_part * m.tolerance),
                                  hanging[w].strand.piece.thickness);
    const double front = m.along(wire.front), back = m.along(wire.back);
    offer(best,
          candidates,
          m,
          std::min(front, back),
          std::max(front, back),
          reach,
          wire.id,
          [&](const Point& p) { return wire.curve.distance(p); });
    if (hasCompanion(growth, hanging[w].strand.piece, reach))
      offer(best,
            candidates,
            m,
            m.begin,
            m.end,
            bundle_reach,
            wire.id,
            [&](const Point& p) {
              const double d = wire.curve.distance(p);
              return d > reach ? d : infinity;
            });
    for (const Piece& companion : hanging[w].strand.companions)
      offer(best,
            candidates,
            companion.model,
            companion.model.begin,
            companion.model.end,
            reach,
            wire.id,
            [&](const Point& p) { return companion.model.distance(p); });
  }

  for (std::size_t k = 0; k < best.size(); ++k) {
    if (best[k].wire == 0)
      continue;
    const Index i = candidates.input[k];
    const Wire& wire = network.wires[static_cast<std::size_t>(best[k].wire - 1)];
    network.classes[i] = wire_class;
    network.wire_id[i] = wire.id;
    network.span_id[i] = wire.span;
    network.wire_distance[i] = static_cast<float>(wire.curve.distance(points[i]));
  }

  const TowerIndex index(towers);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto* near = points[i].allFinite() ? index.near(points[i]) : nullptr;
    if (near == nullptr ||
        points[i].z() < network.ground.heightAt(points[i].x(), points[i].y()) + foot)
      continue;
    const int id = network.wire_id[i];
    const Wire* wire =
        id != 0 ? &network.wires[static_cast<std::size_t>(id - 1)] : nullptr;
    for (const std::size_t t : *near) {
      if (wire != nullptr ? !endsAt(*wire, points[i], towers, static_cast<int>(t))
                          : !belongsTo(towers[t], hanging, points[i]))
        continue;
      network.wire_id[i] = network.span_id[i] = 0;
      network.wire_distance[i] = std::numeric_limits<float>::quiet_NaN();
      network.classes[i] = pylon_class;
      ++network.supports[t].points;
      break;
    }
  }
}

} // namespace linelet::powerline
