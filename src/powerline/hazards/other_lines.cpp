// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/hazards/other_lines.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "powerline/hazards/stretches.h"

namespace linelet::powerline {

namespace {

constexpr double wire_step = 0.5; // meters along a wire

const Circuit*
circuitOf(const PowerLineNetwork& network, const Wire& wire)
{
  const auto place = static_cast<std::size_t>(wire.circuit) - 1;
  return wire.circuit > 0 && place < network.circuits.size() ? &network.circuits[place]
                                                             : nullptr;
}

/** Lines that share a support count as one, as their wires meet there. */
bool
areOfDifferentLines(const PowerLineNetwork& network, const Wire& a, const Wire& b)
{
  if (a.circuit == b.circuit)
    return false;
  for (const int support : {a.front_support, a.back_support})
    if (support != 0 && isOwnSupport(network, b, support))
      return false;
  for (const int support : {b.front_support, b.back_support})
    if (support != 0 && isOwnSupport(network, a, support))
      return false;
  return true;
}

/** Calls visit(a, b) for wires of different lines whose boxes are within \a reach of
 * each other in plan. */
template <class Visit>
void
forEachPair(const PowerLineNetwork& network, double reach, Visit visit)
{
  const std::vector<Wire>& wires = network.wires;
  struct Box {
    Eigen::Vector2d low, high;
    std::size_t wire;
  };
  std::vector<Box> boxes;
  for (std::size_t w = 0; w < wires.size(); ++w) {
    const Eigen::Vector2d a = wires[w].front.head<2>(), b = wires[w].back.head<2>();
    const Eigen::Vector2d rim = Eigen::Vector2d::Constant(reach + wires[w].sag);
    boxes.push_back({a.cwiseMin(b) - rim, a.cwiseMax(b) + rim, w});
  }
  std::sort(boxes.begin(), boxes.end(), [](const Box& a, const Box& b) {
    return a.low.x() < b.low.x();
  });
  for (std::size_t i = 0; i < boxes.size(); ++i)
    for (std::size_t j = i + 1;
         j < boxes.size() && boxes[j].low.x() <= boxes[i].high.x();
         ++j) {
      const std::size_t a = std::min(boxes[i].wire, boxes[j].wire),
                        b = std::max(boxes[i].wire, boxes[j].wire);
      if (boxes[i].low.y() <= boxes[j].high.y() &&
          boxes[j].low.y() <= boxes[i].high.y() &&
          areOfDifferentLines(network, wires[a], wires[b]))
        visit(a, b);
    }
}

/** Places where two curves are closest, alternating between them from a place on the
 * first. */
std::pair<double, double>
closest(const WireCurve& a, const WireCurve& b, double on_a)
{
  double on_b = b.nearest(a.at(on_a));
  for (int k = 0; k < 50; ++k) {
    const double next = a.nearest(b.at(on_b));
    const bool there = std::abs(next - on_a) < 1e-6;
    on_a = next;
    on_b = b.nearest(a.at(on_a));
    if (there)
      break;
  }
  return {on_a, on_b};
}

} // namespace

bool
isOwnSupport(const PowerLineNetwork& network, const Wire& wire, int support)
{
  if (support == wire.front_support || support == wire.back_support)
    return true;
  const Circuit* circuit = circuitOf(network, wire);
  return circuit != nullptr &&
         std::count(circuit->supports.begin(), circuit->supports.end(), support) > 0;
}

void
appendWiresOfOtherLines(const PowerLineNetwork& network,
                        const std::vector<WireCurve>& curves,
                        const ClearanceLimits& limits,
                        std::vector<Encroachment>& out)
{
  const double limit = limits.of(HazardKind::Wire).low;
  forEachPair(network, limit, [&](std::size_t first, std::size_t second) {
    const auto approaches = [&](std::size_t on, std::size_t of) {
      const WireCurve &a = curves[on], &b = curves[of];
      std::vector<Approach> near;
      const int pieces =
          std::max(1, static_cast<int>(std::ceil((b.to() - b.from()) / wire_step)));
      for (int k = 0; k <= pieces; ++k) {
        const Point place = b.at(b.from() + (b.to() - b.from()) * k / pieces);
        if (const Approach one = approach(a, place, limit); one.from <= one.to)
          near.push_back(one);
      }
      if (!near.empty()) {
        const auto best = std::min_element(
            near.begin(), near.end(), [](const Approach& x, const Approach& y) {
              return x.distance < y.distance;
            });
        near.push_back(approach(a, b.at(closest(a, b, best->along).second), limit));
      }
      return near;
    };
    std::vector<Approach> near = approaches(first, second);
    if (near.empty())
      return;
    const Approach& best = *std::min_element(
        near.begin(), near.end(), [](const Approach& x, const Approach& y) {
          return x.distance < y.distance;
        });
    const bool higher = curves[first].at(best.along).z() >= best.place.z();
    const std::size_t upper = higher ? first : second, lower = higher ? second : first;
    appendStretches(network,
                    curves[upper],
                    network.wires[upper],
                    HazardKind::Wire,
                    network.wires[lower].id,
                    limits,
                    higher ? std::move(near) : approaches(upper, lower),
                    out);
  });
}

std::vector<Crossing>
findCrossings(const PowerLineNetwork& network,
              const std::vector<WireCurve>& curves,
              const ClearanceLimits& limits)
{
  std::vector<Crossing> crossings;
  forEachPair(network, 0, [&](std::size_t first, std::size_t second) {
    const WireCurve &a = curves[first], &b = curves[second];
    // Newton's method for where the two cross in plan; there they are straight except
    // for wind.
    double s = 0.5 * (a.from() + a.to()), t = 0.5 * (b.from() + b.to());
    Eigen::Vector2d along_a, along_b;
    for (int k = 0; k < 8; ++k) {
      along_a = (a.at(s + 0.5) - a.at(s - 0.5)).head<2>();
      along_b = (b.at(t + 0.5) - b.at(t - 0.5)).head<2>();
      const Eigen::Vector2d off = (b.at(t) - a.at(s)).head<2>();
      const double turn = along_a.x() * along_b.y() - along_a.y() * along_b.x();
      if (std::abs(turn) < 1e-3)
        return; // practically parallel
      s += (off.x() * along_b.y() - off.y() * along_b.x()) / turn;
      t += (off.x() * along_a.y() - off.y() * along_a.x()) / turn;
      if (!(std::abs(s) < 1e5 && std::abs(t) < 1e5))
        return;
    }
    if (s < a.from() || s > a.to() || t < b.from() || t > b.to())
      return;
    Crossing crossing;
    const bool higher = a.at(s).z() >= b.at(t).z();
    crossing.upper = network.wires[higher ? first : second].id;
    crossing.lower = network.wires[higher ? second : first].id;
    crossing.upper_at = higher ? a.at(s) : b.at(t);
    crossing.lower_at = higher ? b.at(t) : a.at(s);
    crossing.vertical = crossing.upper_at.z() - crossing.lower_at.z();
    const auto [on_a, on_b] = closest(a, b, s);
    const Point upper = higher ? a.at(on_a) : b.at(on_b),
                lower = higher ? b.at(on_b) : a.at(on_a);
    crossing.nearest = {(upper - lower).norm(), upper, lower};
    crossing.horizontal = (upper - lower).head<2>().norm();
    const double cosine =
        std::abs(along_a.dot(along_b)) / (along_a.norm() * along_b.norm());
    crossing.angle = std::acos(std::min(1.0, cosine)) * 180 / M_PI;
    crossing.severity = limits.severity(HazardKind::Wire, crossing.nearest.distance);
    crossings.push_back(crossing);
  });
  std::sort(
      crossings.begin(), crossings.end(), [](const Crossing& a, const Crossing& b) {
        return std::pair(a.upper, a.lower) < std::pair(b.upper, b.lower);
      });
  for (std::size_t k = 0; k < crossings.size(); ++k)
    crossings[k].id = static_cast<int>(k) + 1;
  return crossings;
}

} // namespace linelet::powerline
