// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/supports/towers.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <unordered_map>

#include <Eigen/Dense>

#include "powerline/line_priors.h"
#include "powerline/pieces/growth.h"
#include "powerline/pieces/span_model.h"
#include "powerline/spans/joints.h"
#include "powerline/spans/mend_breaks.h"
#include "powerline/spans/wire_with_ends.h"
#include "powerline/supports/crossarm.h"
#include "powerline/supports/structure.h"
#include "powerline/supports/tower.h"
#include "support/groups.h"

namespace linelet::powerline {

namespace {

constexpr double level_with = 6; // meters along the line between their ends
constexpr double least_cosine = 0.98;
constexpr double margin = 6;         // meters around the attachment points
constexpr double farthest_carry = 8; // meters to the crossarm, without a partner
constexpr double plan_cell = 32;     // meters

End&
endOf(std::vector<WireWithEnds>& wires, std::pair<int, int> id)
{
  return wires[static_cast<std::size_t>(id.first)]
      .ends[static_cast<std::size_t>(id.second)];
}

const End&
endOf(const std::vector<WireWithEnds>& wires, std::pair<int, int> id)
{
  return wires[static_cast<std::size_t>(id.first)]
      .ends[static_cast<std::size_t>(id.second)];
}

std::vector<Tower>
clusterEnds(const std::vector<WireWithEnds>& wires)
{
  Groups groups(2 * wires.size());
  std::vector<std::size_t> order(2 * wires.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto place = [&](std::size_t e) -> const Point& {
    return wires[e / 2].ends[e % 2].place;
  };
  const auto leavesAt = [&](std::size_t e) { return wires[e / 2].leaves[e % 2]; };
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::tuple(place(a).x(), a) < std::tuple(place(b).x(), b);
  });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::size_t a = order[i];
    const End& end = wires[a / 2].ends[a % 2];
    if (leavesAt(a))
      continue;
    if (end.partner >= 0)
      groups.unite(a,
                   2 * static_cast<std::size_t>(end.partner) +
                       static_cast<std::size_t>(end.partner_side));
    const Eigen::Vector2d out = wires[a / 2].outward(static_cast<int>(a % 2));
    for (std::size_t k = i + 1;
         k < order.size() && place(order[k]).x() <= place(a).x() + priors.company_reach;
         ++k) {
      const std::size_t b = order[k];
      const Eigen::Vector2d offset = (place(b) - place(a)).head<2>();
      if (a / 2 != b / 2 && !leavesAt(b) && offset.norm() <= priors.company_reach &&
          std::abs(out.dot(offset)) <= level_with &&
          out.dot(wires[b / 2].outward(static_cast<int>(b % 2))) >= least_cosine)
        groups.unite(a, b);
    }
  }
  std::vector<Tower> towers;
  std::vector<int> tower_of(order.size(), -1);
  for (std::size_t e = 0; e < order.size(); ++e) {
    if (leavesAt(e))
      continue;
    int& tower = tower_of[groups.root(e)];
    if (tower < 0) {
      tower = static_cast<int>(towers.size());
      towers.emplace_back();
    }
    towers[static_cast<std::size_t>(tower)].ends.emplace_back(static_cast<int>(e / 2),
                                                              static_cast<int>(e % 2));
  }
  return towers;
}

// The candidates that no wire owns near each tower.
std::vector<Indices>
pointsNear(const std::vector<Tower>& towers, const Growth& growth)
{
  const auto cellOf = [](double x, double y) {
    const auto part = [](double v) {
      return static_cast<std::uint64_t>(
          static_cast<std::int64_t>(std::floor(v / plan_cell)) & 0xFFFFFFFF);
    };
    return part(x) << 32 | part(y);
  };
  std::unordered_map<std::uint64_t, std::vector<std::size_t>> cells;
  for (std::size_t t = 0; t < towers.size(); ++t) {
    const double r = towers[t].reach + margin;
    const Eigen::Vector2d& c = towers[t].arm.center;
    for (double x = std::floor((c.x() - r) / plan_cell); x <= (c.x() + r) / plan_cell;
         ++x)
      for (double y = std::floor((c.y() - r) / plan_cell); y <= (c.y() + r) / plan_cell;
           ++y)
        cells[cellOf(x * plan_cell, y * plan_cell)].push_back(t);
  }
  std::vector<Indices> near(towers.size());
  const Points& points = growth.candidates().points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto cell = cells.find(cellOf(points[i].x(), points[i].y()));
    if (cell == cells.end() || growth.owner(static_cast<Index>(i)) != Growth::nobody)
      continue;
    for (const std::size_t t : cell->second)
      if ((points[i].head<2>() - towers[t].arm.center).norm() <=
          towers[t].reach + margin)
        near[t].push_back(static_cast<Index>(i));
  }
  return near;
}

// Direction of the line at the support, center and size from the attachment points.
void
orient(Tower& tower, const std::vector<WireWithEnds>& wires)
{
  const auto outward = [&](std::pair<int, int> id) {
    return wires[static_cast<std::size_t>(id.first)].outward(id.second);
  };
  const Eigen::Vector2d first = outward(tower.ends.front());
  Eigen::Vector2d there = Eigen::Vector2d::Zero(), back = there;
  bool fixed = false;
  tower.lowest_arm = std::numeric_limits<double>::infinity();
  tower.top = -tower.lowest_arm;
  for (const auto& id : tower.ends) {
    const Eigen::Vector2d out = outward(id);
    (out.dot(first) >= 0 ? there : back) += out;
    fixed = fixed || endOf(wires, id).fixed;
  }
  const auto unit = [](const Eigen::Vector2d& v) -> Eigen::Vector2d {
    return v.norm() > 0 ? Eigen::Vector2d(v.normalized()) : v;
  };
  tower.arm.along = unit(unit(there) - unit(back));
  if (there.norm() > 0 && back.norm() > 0)
    tower.turn =
        std::acos(std::clamp(-unit(there).dot(unit(back)), -1.0, 1.0)) * 180 / M_PI;
  const Eigen::Vector2d across(-tower.arm.along.y(), tower.arm.along.x());
  double low = std::numeric_limits<double>::infinity(), high = -low, sum = 0, count = 0;
  for (const auto& id : tower.ends) {
    const End& end = endOf(wires, id);
    tower.lowest_arm = std::min(tower.lowest_arm, end.place.z());
    tower.top = std::max(tower.top, end.place.z());
    if (fixed && !end.fixed)
      continue;
    low = std::min(low, across.dot(end.place.head<2>()));
    high = std::max(high, across.dot(end.place.head<2>()));
    sum += tower.arm.along.dot(end.place.head<2>());
    count += 1;
  }
  tower.arm.center = sum / count * tower.arm.along + (low + high) / 2 * across;
  tower.reach = (high - low) / 2;
}

// Extends the ends of a tower to its crossarm.
void
settle(const Tower& tower, std::vector<WireWithEnds>& wires, double max_gap)
{
  const Crossarm& arm = tower.arm;
  const Eigen::Vector2d across(-arm.along.y(), arm.along.x());
  const Eigen::Vector2d level = arm.along - arm.turn * across;
  for (const auto& id : tower.ends) {
    WireWithEnds& wire = wires[static_cast<std::size_t>(id.first)];
    End& end = wire.ends[static_cast<std::size_t>(id.second)];
    if (end.partner >= 0) {
      const WireWithEnds& other = wires[static_cast<std::size_t>(end.partner)];
      // Once for both, in a fixed order, so that they share exactly the same point.
      if (id.first < end.partner) {
        const Meeting m = meet(wire, id.second, other, end.partner_side, arm);
        end.place = m.places[0];
        endOf(wires, {end.partner, end.partner_side}).place = m.places[1];
      }
      continue;
    }
    if (arm.spread < 0)
      continue;
    const SpanModel& model = wire.model();
    const double last = wire.edge(id.second);
    const Point place = model.at(last);
    const Eigen::Vector2d forward = (model.at(last + 1) - place).head<2>();
    const double rate = level.dot(forward);
    if (std::abs(rate) < 0.3)
      continue;
    const double carry = -level.dot(place.head<2>() - arm.center) / rate;
    const double onwards = id.second == 0 ? -carry : carry;
    if (onwards > std::min(farthest_carry, max_gap) || onwards < -farthest_carry / 2)
      continue;
    end.place = model.at(last + carry);
    end.fixed = true;
  }
}

// Extends service drops to the support they hang from.
void
attachDrops(const std::vector<Tower>& towers, std::vector<WireWithEnds>& wires)
{
  for (WireWithEnds& wire : wires)
    for (int side = 0; side < 2; ++side) {
      if (!wire.leaves[static_cast<std::size_t>(side)])
        continue;
      const SpanModel& m = wire.model();
      End& end = wire.ends[static_cast<std::size_t>(side)];
      double nearest = priors.drop_reach;
      for (std::size_t t = 0; t < towers.size(); ++t) {
        const Eigen::Vector2d& axis = towers[t].arm.center;
        const double s = m.along({axis.x(), axis.y(), 0});
        const double on = std::abs(s - wire.edge(side));
        const Point place = m.at(s);
        if (on > nearest || (place.head<2>() - axis).norm() > priors.drop_beside ||
            place.z() > towers[t].top + 1 || place.z() < towers[t].base)
          continue;
        nearest = on;
        end.place = place;
        end.fixed = true;
        end.support = static_cast<int>(t);
      }
    }
}

} // namespace

std::vector<Tower>
buildTowers(std::vector<WireWithEnds>& wires,
            const Growth& growth,
            const Ground& ground,
            const PowerLineSettings& settings)
{
  std::vector<Tower> towers = clusterEnds(wires);
  for (Tower& tower : towers) {
    orient(tower, wires);
    tower.base = ground.heightAt(tower.arm.center.x(), tower.arm.center.y());
    fitCrossarm(tower, wires);
    if (tower.top - tower.base < lowest_pylon)
      moveToKink(tower, wires, growth.candidates().points);
  }
  const std::vector<Indices> near = pointsNear(towers, growth);
  std::vector<Tower> kept;
  for (std::size_t t = 0; t < towers.size(); ++t) {
    Tower& tower = towers[t];
    findStructure(tower, growth.candidates().points, near[t]);
    const bool joined = std::any_of(tower.ends.begin(), tower.ends.end(), [&](auto id) {
      return endOf(wires, id).partner >= 0;
    });
    const Point arm(tower.arm.center.x(), tower.arm.center.y(), tower.lowest_arm);
    const bool pole = tower.pole && tower.seen; // other wires may pass above it
    if ((!joined && !tower.seen) ||
        (!pole && isPassedBy(wires, arm, tower.arm.along, tower.ends.size())))
      continue;
    if (tower.arm.spread < 0)
      tower.arm.spread = tower.pole ? 0.5 : 1;
    settle(tower, wires, settings.max_gap);
    const auto away = [&](std::pair<int, int> id) {
      return (endOf(wires, id).place.head<2>() - tower.arm.center).norm();
    };
    for (const auto& id : tower.ends) {
      // A short wire may have both ends here; the nearer one hangs from this support.
      const std::pair<int, int> other(id.first, 1 - id.second);
      const bool both =
          std::find(tower.ends.begin(), tower.ends.end(), other) != tower.ends.end();
      if (!both || away(id) < away(other))
        endOf(wires, id).support = static_cast<int>(kept.size());
    }
    kept.push_back(std::move(tower));
  }
  attachDrops(kept, wires);
  return kept;
}

} // namespace linelet::powerline
