// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>

#include "powerline/describe.h"

namespace linelet::powerline {

namespace {

constexpr double side_by_side = 14; // metres between neighbouring wires of a span
constexpr double shared_part = 0.6; // of the longer wire

std::size_t
rootOf(std::vector<std::size_t>& parent, std::size_t i)
{
  while (parent[i] != i)
    i = parent[i] = parent[parent[i]];
  return i;
}

/** A span under way: its wires, and who follows at either end. */
struct Group {
  std::vector<std::size_t> wires;
  int support[2] = {0, 0};      ///< ids
  std::size_t next[2] = {0, 0}; ///< group + 1 beyond either end, 0: none
  int next_side[2] = {0, 0};    ///< its end there
  std::vector<char> reversed;   ///< wire runs from end 1 to end 0
};

bool
inOneSpan(const Hanging& a, const Hanging& b)
{
  const int a0 = a.ends[0].support, a1 = a.ends[1].support;
  const int b0 = b.ends[0].support, b1 = b.ends[1].support;
  if (a0 >= 0 && a1 >= 0 && b0 >= 0 && b1 >= 0)
    return std::minmax(a0, a1) == std::minmax(b0, b1);
  const Parallel parallel = compare(a.model(), b.model());
  if (parallel.overlap < shared_part * std::max(a.model().length(), b.model().length()))
    return false;
  // Levels above each other are apart as well, but what counts is the plan.
  const SpanModel& m = a.model();
  const double s = (m.begin + m.end) / 2;
  const Point beside = b.model().at(b.model().along(m.at(s)));
  if ((m.at(s) - beside).head<2>().norm() > side_by_side)
    return false;
  const bool same = m.direction.dot(b.model().direction) > 0;
  const auto fits = [](int x, int y) { return x < 0 || y < 0 || x == y; };
  return fits(a0, same ? b0 : b1) && fits(a1, same ? b1 : b0);
}

std::vector<Group>
gatherSpans(const std::vector<Hanging>& wires)
{
  const std::size_t n = wires.size();
  std::vector<std::size_t> parent(n), order(n);
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto left = [&](std::size_t w) {
    return std::min(wires[w].ends[0].place.x(), wires[w].ends[1].place.x());
  };
  const auto right = [&](std::size_t w) {
    return std::max(wires[w].ends[0].place.x(), wires[w].ends[1].place.x());
  };
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::tuple(left(a), a) < std::tuple(left(b), b);
  });
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = i + 1;
         k < n && left(order[k]) <= right(order[i]) + side_by_side;
         ++k)
      if (inOneSpan(wires[order[i]], wires[order[k]])) {
        const std::size_t a = rootOf(parent, order[i]), b = rootOf(parent, order[k]);
        parent[std::max(a, b)] = std::min(a, b);
      }
  std::vector<Group> groups;
  std::map<std::size_t, std::size_t> place;
  for (std::size_t w = 0; w < n; ++w) {
    const auto [it, is_new] = place.emplace(rootOf(parent, w), groups.size());
    if (is_new)
      groups.emplace_back();
    Group& group = groups[it->second];
    const bool reversed =
        !group.wires.empty() && wires[w].model().direction.dot(
                                    wires[group.wires.front()].model().direction) < 0;
    group.wires.push_back(w);
    group.reversed.push_back(reversed);
    for (int side = 0; side < 2; ++side) {
      const int support =
          wires[w].ends[static_cast<std::size_t>(reversed ? 1 - side : side)].support;
      if (group.support[side] == 0)
        group.support[side] = support + 1;
    }
  }
  return groups;
}

// Links every end of a span with the span that most of its wires go on to.
void
linkSpans(std::vector<Group>& groups, const std::vector<Hanging>& wires)
{
  std::vector<std::size_t> group_of(wires.size());
  std::vector<char> reversed(wires.size());
  for (std::size_t g = 0; g < groups.size(); ++g)
    for (std::size_t k = 0; k < groups[g].wires.size(); ++k) {
      group_of[groups[g].wires[k]] = g;
      reversed[groups[g].wires[k]] = groups[g].reversed[k];
    }
  std::map<std::tuple<std::size_t, int, std::size_t, int>, int> votes;
  for (std::size_t w = 0; w < wires.size(); ++w)
    for (int side = 0; side < 2; ++side) {
      const End& end = wires[w].ends[static_cast<std::size_t>(side)];
      if (end.partner < 0)
        continue;
      const auto other = static_cast<std::size_t>(end.partner);
      const int here = reversed[w] != 0 ? 1 - side : side;
      const int there = reversed[other] != 0 ? 1 - end.partner_side : end.partner_side;
      if (group_of[w] < group_of[other])
        ++votes[{group_of[w], here, group_of[other], there}];
    }
  std::vector<std::pair<int, std::tuple<std::size_t, int, std::size_t, int>>> sorted;
  for (const auto& [link, count] : votes)
    sorted.emplace_back(-count, link);
  std::sort(sorted.begin(), sorted.end());
  for (const auto& [count, link] : sorted) {
    const auto [a, side_a, b, side_b] = link;
    if (groups[a].next[side_a] != 0 || groups[b].next[side_b] != 0)
      continue;
    groups[a].next[side_a] = b + 1;
    groups[a].next_side[side_a] = side_b;
    groups[b].next[side_b] = a + 1;
    groups[b].next_side[side_b] = side_a;
  }
}

void
turnAround(Wire& wire)
{
  std::swap(wire.front, wire.back);
  std::swap(wire.front_support, wire.back_support);
  Catenary& c = wire.curve;
  std::swap(c.from, c.to);
  c.from = -c.from;
  c.to = -c.to;
  c.swing = -c.swing;
  c.azimuth = std::fmod(c.azimuth + 180, 360.0);
}

} // namespace

std::vector<int>
numberWires(PowerLineNetwork& network,
            const std::vector<Hanging>& hanging,
            const std::vector<Tower>& towers)
{
  std::vector<Group> groups = gatherSpans(hanging);
  linkSpans(groups, hanging);
  std::vector<std::size_t> conductor(hanging.size());
  std::iota(conductor.begin(), conductor.end(), std::size_t{0});
  for (std::size_t w = 0; w < hanging.size(); ++w)
    for (const End& end : hanging[w].ends)
      if (end.partner >= 0) {
        const std::size_t a = rootOf(conductor, w);
        const std::size_t b = rootOf(conductor, static_cast<std::size_t>(end.partner));
        conductor[std::max(a, b)] = std::min(a, b);
      }

  std::vector<Wire> ordered;
  std::vector<int> ids(hanging.size(), 0);
  std::vector<char> done(groups.size(), 0);
  // Chains with a loose end first; what is left are rings.
  for (int pass = 0; pass < 2; ++pass)
    for (std::size_t first = 0; first < groups.size(); ++first) {
      if (done[first] != 0 ||
          (pass == 0 && groups[first].next[0] != 0 && groups[first].next[1] != 0))
        continue;
      Circuit circuit;
      circuit.id = static_cast<int>(network.circuits.size()) + 1;
      std::map<std::size_t, int> number_of; // conductor -> number
      std::size_t g = first;
      int entry = groups[first].next[0] == 0 ? 0 : 1;
      while (done[g] == 0) {
        done[g] = 1;
        const Group& group = groups[g];
        Span span;
        span.id = static_cast<int>(network.spans.size()) + 1;
        span.circuit = circuit.id;
        span.number = static_cast<int>(circuit.spans.size()) + 1;
        span.from_support = group.support[entry];
        span.to_support = group.support[1 - entry];
        circuit.spans.push_back(span.id);
        if (circuit.supports.empty())
          circuit.supports.push_back(span.from_support);
        circuit.supports.push_back(span.to_support);

        std::vector<std::pair<std::size_t, Wire>> wires;
        Point middle = Point::Zero();
        Eigen::Vector2d forward = Eigen::Vector2d::Zero();
        for (std::size_t k = 0; k < group.wires.size(); ++k) {
          Wire wire = network.wires[group.wires[k]];
          if ((group.reversed[k] != 0) != (entry == 1))
            turnAround(wire);
          middle += (wire.front + wire.back) / 2;
          forward += (wire.back - wire.front).head<2>();
          span.length += wire.span_length / static_cast<double>(group.wires.size());
          wires.emplace_back(group.wires[k], std::move(wire));
        }
        middle /= static_cast<double>(wires.size());
        forward.normalize();
        span.azimuth = std::atan2(forward.x(), forward.y()) * 57.29577951308232;
        if (span.azimuth < 0)
          span.azimuth += 360;
        // From left to right in steps of a metre, then downwards.
        const auto rank = [&](const Wire& wire) {
          const Point offset = (wire.front + wire.back) / 2 - middle;
          return std::tuple(
              std::round(forward.y() * offset.x() - forward.x() * offset.y()),
              -offset.z());
        };
        std::sort(wires.begin(), wires.end(), [&](const auto& a, const auto& b) {
          return rank(a.second) < rank(b.second);
        });
        std::map<int, std::size_t> taken;
        for (auto& [w, wire] : wires) {
          const auto [it, is_new] = number_of.emplace(
              rootOf(conductor, w), static_cast<int>(number_of.size()) + 1);
          wire.number = it->second;
          // Two parts of one conductor in one span cannot share its number.
          if (!taken.emplace(wire.number, w).second) {
            number_of.emplace(hanging.size() + w,
                              static_cast<int>(number_of.size()) + 1);
            wire.number = static_cast<int>(number_of.size());
          }
        }
        std::sort(wires.begin(), wires.end(), [](const auto& a, const auto& b) {
          return a.second.number < b.second.number;
        });
        for (auto& [w, wire] : wires) {
          wire.id = static_cast<int>(ordered.size()) + 1;
          wire.span = span.id;
          wire.circuit = circuit.id;
          ids[w] = wire.id;
          span.wires.push_back(wire.id);
          ordered.push_back(std::move(wire));
        }
        network.spans.push_back(std::move(span));
        if (group.next[1 - entry] == 0)
          break;
        const std::size_t next = group.next[1 - entry] - 1;
        entry = group.next_side[1 - entry];
        g = next;
      }
      network.circuits.push_back(std::move(circuit));
    }
  network.wires = std::move(ordered);

  for (std::size_t t = 0; t < towers.size(); ++t) {
    const Tower& tower = towers[t];
    Support support;
    support.id = static_cast<int>(t) + 1;
    support.kind = tower.pole ? Support::Kind::Pole : Support::Kind::Pylon;
    support.base = {tower.arm.centre.x(), tower.arm.centre.y(), tower.base};
    support.top = {tower.arm.centre.x(), tower.arm.centre.y(), tower.top};
    support.height = tower.top - tower.base;
    support.confidence = tower.confidence;
    network.supports.push_back(support);
  }
  return ids;
}

} // namespace linelet::powerline
