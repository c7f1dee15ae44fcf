// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/network/label_points.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>

#include "powerline/pieces/candidates.h"
#include "powerline/pieces/growth.h"
#include "powerline/pieces/span_model.h"
#include "powerline/spans/wire_with_ends.h"
#include "powerline/supports/structure.h"
#include "powerline/supports/tower.h"

namespace linelet::powerline {

namespace {

constexpr double widest_tube = 0.3; // meters
constexpr double tube_part = 1.25;  // of the tolerance of a wire
// Meters of a wire's end that are given to its support: fittings, and where the line
// turns the insulators, which then lie in line with the wire (longer ones at sharper
// turns).
constexpr double fittings = 1, strain_rate = 0.28, longest_strain = 4.5;
constexpr double tension_angle = 10;   // degrees; a line that turns less is suspended
constexpr double foot = 2;             // meters above ground; below is grass
constexpr double bundle_reach = 0.6;   // meters between conductors of a bundle
constexpr double least_companion = 4;  // points
constexpr double companion_part = 0.3; // of the points of the conductor that was found
constexpr double plan_cell = 16;       // meters

/** The space around a stretch of a model in which a wire claims points. */
struct Tube {
  const SpanModel& model;
  double from, to; ///< along the model
  double reach;    ///< meters
};

/** Which wire every candidate goes to: the nearest of those in whose tubes it lies. */
class Claims {
public:
  explicit Claims(const Candidates& candidates)
      : candidates_(candidates), best_(candidates.points.size())
  {
  }

  /** Offers the candidates in \a tube to a wire; \a distance gives their distance from
   * it. */
  template <class Distance>
  void
  offer(const Tube& tube, int wire, Distance&& distance)
  {
    const SpanModel& model = tube.model;
    const int steps =
        std::max(1, static_cast<int>(std::ceil((tube.to - tube.from) / bin_length)));
    const double step = (tube.to - tube.from) / steps;
    for (int k = 0; k < steps; ++k) {
      const double begin = tube.from + k * step, end = begin + step;
      const double rise = step * std::abs(model.rise(begin + step / 2));
      candidates_.grid.forEachWithin(
          model.at(begin + step / 2),
          std::hypot(step, rise) / 2 + 2 * tube.reach,
          [&](Index i, double) {
            const double s = model.along(candidates_.points[i]);
            if (s < begin || s > end)
              return;
            const auto d = static_cast<float>(distance(candidates_.points[i]));
            if (d <= tube.reach && d < best_[i].distance)
              best_[i] = {d, wire};
          });
    }
  }

  /** Id of the wire that candidate \a i goes to, 0: none. */
  int
  wireOf(Index i) const
  {
    return best_[i].wire;
  }

private:
  struct Best {
    float distance = std::numeric_limits<float>::infinity();
    std::int32_t wire = 0;
  };

  const Candidates& candidates_;
  std::vector<Best> best_;
};

// Whether points beside a wire, outside its tube, are another conductor of its bundle
// without its own vector: they stand out from what is farther away.
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

// Offers a wire the points in its own tube, and those of conductors of its bundle
// without their own vectors.
void
offerAround(const Wire& wire,
            const WireWithEnds& with_ends,
            const Growth& growth,
            Claims& claims)
{
  const SpanModel& m = with_ends.model();
  const Piece& piece = with_ends.strand.piece;
  const double reach =
      std::max(std::min(widest_tube, tube_part * m.tolerance), piece.thickness);
  const double front = m.along(wire.front), back = m.along(wire.back);
  claims.offer({m, std::min(front, back), std::max(front, back), reach},
               wire.id,
               [&](const Point& p) { return wire.curve.distance(p); });
  if (hasCompanion(growth, piece, reach))
    claims.offer({m, m.begin, m.end, bundle_reach}, wire.id, [&](const Point& p) {
      // Points in its own tube were already offered.
      const double d = wire.curve.distance(p);
      return d > reach ? d : std::numeric_limits<double>::infinity();
    });
  for (const Piece& companion : with_ends.strand.companions) {
    const SpanModel& other = companion.model;
    claims.offer({other, other.begin, other.end, reach}, wire.id, [&](const Point& p) {
      return other.distance(p);
    });
  }
}

// Gives every wire the points that it claims.
void
labelWires(PowerLineNetwork& network,
           const Points& points,
           const Candidates& candidates,
           const Claims& claims)
{
  for (std::size_t k = 0; k < candidates.points.size(); ++k) {
    const int id = claims.wireOf(static_cast<Index>(k));
    if (id == 0)
      continue;
    const Index i = candidates.input[k];
    const Wire& wire = network.wires[static_cast<std::size_t>(id - 1)];
    network.classes[i] = wire_class;
    network.wire_id[i] = wire.id;
    network.span_id[i] = wire.span;
    network.wire_distance[i] = static_cast<float>(wire.curve.distance(points[i]));
  }
}

// Meters of a wire's end that are given to the support there.
double
endPart(const Tower& tower)
{
  const double fitting = tower.pole ? 0.3 : fittings;
  return std::clamp(
      fitting + strain_rate * (tower.turn - tension_angle), fitting, longest_strain);
}

// Whether a point of a wire is so near its end that it belongs to the support there.
bool
endsAt(const Wire& wire, const Point& p, const Tower& tower, int tower_id)
{
  const auto within = [&](int id, const Point& end) {
    return id == tower_id && tower.seen && (p - end).head<2>().norm() <= endPart(tower);
  };
  return within(wire.front_support, wire.front) || within(wire.back_support, wire.back);
}

/** The supports near each cell of the plan. */
class TowerIndex {
public:
  explicit TowerIndex(const std::vector<Tower>& towers)
  {
    for (std::size_t t = 0; t < towers.size(); ++t) {
      const double r = std::max(towers[t].reach + 2, 10.0);
      const Eigen::Vector2d& c = towers[t].arm.center;
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

// Gives a support everything above the grass there: its own points, and the ends of its
// wires.
void
labelSupports(PowerLineNetwork& network,
              const Points& points,
              const std::vector<WireWithEnds>& with_ends,
              const std::vector<Tower>& towers)
{
  const TowerIndex index(towers);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point& p = points[i];
    const auto* near = p.allFinite() ? index.near(p) : nullptr;
    if (near == nullptr || p.z() < network.ground.heightAt(p.x(), p.y()) + foot)
      continue;
    const int id = network.wire_id[i];
    const auto isPartOf = [&](std::size_t t) {
      return id == 0 ? belongsTo(towers[t], with_ends, p)
                     : endsAt(network.wires[static_cast<std::size_t>(id - 1)],
                              p,
                              towers[t],
                              network.supports[t].id);
    };
    const auto tower = std::find_if(near->begin(), near->end(), isPartOf);
    if (tower == near->end())
      continue;
    network.wire_id[i] = network.span_id[i] = 0;
    network.wire_distance[i] = std::numeric_limits<float>::quiet_NaN();
    network.classes[i] = pylon_class;
    Support& support = network.supports[*tower];
    ++support.points;
    if (network.ground.heights.empty()) // the best guess of its foot
      support.base.z() = std::min(support.base.z(), p.z());
  }
}

} // namespace

void
labelPoints(PowerLineNetwork& network,
            const Points& points,
            const std::vector<WireWithEnds>& with_ends,
            const std::vector<int>& ids,
            const std::vector<Tower>& towers,
            const Growth& growth)
{
  Claims claims(growth.candidates());
  for (std::size_t w = 0; w < with_ends.size(); ++w)
    offerAround(network.wires[static_cast<std::size_t>(ids[w] - 1)],
                with_ends[w],
                growth,
                claims);
  labelWires(network, points, growth.candidates(), claims);
  labelSupports(network, points, with_ends, towers);
}

} // namespace linelet::powerline
