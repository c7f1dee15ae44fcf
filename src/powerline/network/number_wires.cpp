// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/network/number_wires.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "powerline/network/gather_spans.h"
#include "powerline/spans/wire_groups.h"
#include "powerline/spans/wire_with_ends.h"

namespace linelet::powerline {

namespace {

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

/** A wire without an id yet. */
struct Unnumbered {
  std::size_t place; ///< in the list of wires with ends
  Wire wire;
};

/** Position and direction of a span in plan. */
struct Course {
  Point middle = Point::Zero();
  Eigen::Vector2d forward = Eigen::Vector2d::Zero(); ///< unit length

  explicit Course(const std::vector<Unnumbered>& wires)
  {
    for (const auto& [place, wire] : wires) {
      middle += (wire.front + wire.back) / 2;
      forward += (wire.back - wire.front).head<2>();
    }
    middle /= static_cast<double>(wires.size());
    forward.normalize();
  }

  double
  azimuth() const
  {
    const double degrees = std::atan2(forward.x(), forward.y()) * 180 / M_PI;
    return degrees < 0 ? degrees + 360 : degrees;
  }
};

// Sorts the wires of a span from left to right in steps of a meter, then downward.
void
sortAcross(std::vector<Unnumbered>& wires, const Course& course)
{
  const auto rank = [&](const Wire& wire) {
    const Point offset = (wire.front + wire.back) / 2 - course.middle;
    const Eigen::Vector2d& forward = course.forward;
    return std::tuple(std::round(forward.y() * offset.x() - forward.x() * offset.y()),
                      -offset.z());
  };
  std::sort(wires.begin(), wires.end(), [&](const Unnumbered& a, const Unnumbered& b) {
    return rank(a.wire) < rank(b.wire);
  });
}

/** Walks along the lines from span to span and gives ids and numbers on the way. */
class Numbering {
public:
  Numbering(PowerLineNetwork& network, const std::vector<WireWithEnds>& with_ends)
      : network_(network),
        spans_(gatherSpans(with_ends)),
        conductors_(with_ends.size()),
        ids_(with_ends.size(), 0),
        visited_(spans_.size(), 0)
  {
    unitePartners(conductors_, with_ends);
  }

  /** Sorts the network. Returns the id of every wire with ends. */
  std::vector<int>
  run()
  {
    // Lines with a loose end first; what remains are rings.
    for (const bool rings : {false, true})
      for (std::size_t k = 0; k < spans_.size(); ++k) {
        const auto& next = spans_[k].next;
        if (visited_[k] == 0 && (rings || next[0].span < 0 || next[1].span < 0))
          followLine({static_cast<int>(k), next[0].span < 0 ? 0 : 1});
      }
    network_.wires = std::move(ordered_);
    return std::move(ids_);
  }

private:
  /** Numbers of the conductors of a line, in order of appearance. */
  using Numbers = std::map<std::size_t, int>;

  static int
  numberOf(std::size_t conductor, Numbers& numbers)
  {
    return numbers.emplace(conductor, static_cast<int>(numbers.size()) + 1)
        .first->second;
  }

  void
  followLine(Next at)
  {
    Circuit circuit;
    circuit.id = static_cast<int>(network_.circuits.size()) + 1;
    Numbers numbers;
    while (at.span >= 0 && visited_[static_cast<std::size_t>(at.span)] == 0) {
      const auto k = static_cast<std::size_t>(at.span);
      const auto entry = static_cast<std::size_t>(at.side);
      visited_[k] = 1;
      addSpan(spans_[k], entry, circuit, numbers);
      at = spans_[k].next[1 - entry];
    }
    network_.circuits.push_back(std::move(circuit));
  }

  // Adds the next span of \a circuit, entered at its end \a entry.
  void
  addSpan(const WiresOfSpan& group,
          std::size_t entry,
          Circuit& circuit,
          Numbers& numbers)
  {
    std::vector<Unnumbered> wires = wiresFrom(group, entry);
    const Course course(wires);
    Span span;
    span.id = static_cast<int>(network_.spans.size()) + 1;
    span.circuit = circuit.id;
    span.number = static_cast<int>(circuit.spans.size()) + 1;
    span.from_support = group.support[entry];
    span.to_support = group.support[1 - entry];
    span.azimuth = course.azimuth();
    for (const auto& [place, wire] : wires)
      span.length += wire.span_length / static_cast<double>(wires.size());
    sortAcross(wires, course);
    giveNumbers(wires, numbers);
    giveIds(wires, span);

    circuit.spans.push_back(span.id);
    if (circuit.supports.empty())
      circuit.supports.push_back(span.from_support);
    circuit.supports.push_back(span.to_support);
    network_.spans.push_back(std::move(span));
  }

  // The wires of a span, all turned to run from its end \a entry.
  std::vector<Unnumbered>
  wiresFrom(const WiresOfSpan& group, std::size_t entry) const
  {
    std::vector<Unnumbered> wires;
    for (std::size_t k = 0; k < group.wires.size(); ++k) {
      wires.push_back({group.wires[k], network_.wires[group.wires[k]]});
      if ((group.reversed[k] != 0) != (entry == 1))
        turnAround(wires.back().wire);
    }
    return wires;
  }

  // A conductor keeps its number from span to span.
  void
  giveNumbers(std::vector<Unnumbered>& wires, Numbers& numbers)
  {
    std::set<int> taken;
    for (auto& [place, wire] : wires) {
      wire.number = numberOf(conductors_.root(place), numbers);
      // Two parts of one conductor in one span cannot share its number: the second
      // becomes its own conductor.
      if (!taken.insert(wire.number).second)
        wire.number = numberOf(ids_.size() + place, numbers);
    }
    std::sort(wires.begin(), wires.end(), [](const Unnumbered& a, const Unnumbered& b) {
      return a.wire.number < b.wire.number;
    });
  }

  void
  giveIds(std::vector<Unnumbered>& wires, Span& span)
  {
    for (auto& [place, wire] : wires) {
      wire.id = static_cast<int>(ordered_.size()) + 1;
      wire.span = span.id;
      wire.circuit = span.circuit;
      ids_[place] = wire.id;
      span.wires.push_back(wire.id);
      ordered_.push_back(std::move(wire));
    }
  }

  PowerLineNetwork& network_;
  std::vector<WiresOfSpan> spans_;
  Groups conductors_; ///< wires that continue each other from span to span
  std::vector<int> ids_;
  std::vector<char> visited_;
  std::vector<Wire> ordered_;
};

} // namespace

std::vector<int>
numberWires(PowerLineNetwork& network, const std::vector<WireWithEnds>& with_ends)
{
  return Numbering(network, with_ends).run();
}

} // namespace linelet::powerline
