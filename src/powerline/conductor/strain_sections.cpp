// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/powerline/strain_sections.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace linelet::powerline {

namespace {

constexpr double shared = 1; // meters between ends of wires at one support

/** A wire of a section, which may run against the wire's own direction. */
struct Link {
  const Wire* wire;
  bool turned;

  const Point&
  start() const
  {
    return turned ? wire->back : wire->front;
  }
  const Point&
  end() const
  {
    return turned ? wire->front : wire->back;
  }
  int
  endSupport() const
  {
    return turned ? wire->front_support : wire->back_support;
  }
};

double
turnBetween(const Link& a, const Link& b)
{
  const Eigen::Vector2d u = (a.end() - a.start()).head<2>(),
                        v = (b.end() - b.start()).head<2>();
  return std::abs(std::atan2(u.x() * v.y() - u.y() * v.x(), u.dot(v))) * 180 / M_PI;
}

/** Standard deviation of a catenary constant, from that of the sag. */
double
deviation(const Wire& wire)
{
  return wire.curve.a * std::max(wire.rms, 0.01) / std::max(wire.sag, 0.01);
}

bool
isDeadEnd(const Link& a, const Link& b, const StateSettings& settings)
{
  const int support = a.endSupport();
  return std::count(settings.dead_ends.begin(), settings.dead_ends.end(), support) >
             0 ||
         turnBetween(a, b) > settings.dead_end_angle ||
         std::abs(a.wire->curve.a - b.wire->curve.a) >
             4 * std::hypot(deviation(*a.wire), deviation(*b.wire));
}

/** The wire that continues from the end of \a link. */
bool
findNext(const std::vector<Wire>& wires, const Link& link, Link& next)
{
  double least = shared;
  for (const Wire& wire : wires)
    if (wire.circuit == link.wire->circuit && wire.id != link.wire->id &&
        link.endSupport() != 0)
      for (const bool turned : {false, true}) {
        const Link candidate{&wire, turned};
        const int support = turned ? wire.back_support : wire.front_support;
        const double off = (candidate.start() - link.end()).norm();
        if (support == link.endSupport() && off < least) {
          least = off;
          next = candidate;
        }
      }
  return least < shared;
}

/** Chains of links, each wire in one of them. */
std::vector<std::vector<Link>>
chainsOf(const std::vector<Wire>& wires, const StateSettings& settings)
{
  std::vector<bool> used(wires.size(), false);
  std::vector<std::vector<Link>> chains;
  const auto follow = [&](Link link, std::vector<Link>& chain) {
    for (Link next = link; findNext(wires, link, next); link = next) {
      const auto place = static_cast<std::size_t>(next.wire - wires.data());
      if (used[place] || isDeadEnd(link, next, settings))
        break;
      used[place] = true;
      chain.push_back(next);
    }
  };
  for (std::size_t w = 0; w < wires.size(); ++w) {
    if (used[w])
      continue;
    used[w] = true;
    std::vector<Link> chain = {{&wires[w], true}};
    follow(chain.front(), chain); // backward
    std::reverse(chain.begin(), chain.end());
    for (Link& link : chain)
      link.turned = !link.turned;
    follow(chain.back(), chain);
    chains.push_back(std::move(chain));
  }
  return chains;
}

/** The span of a wire in the plane of its load. */
SpanShape
shapeOf(const Wire& wire, double swing)
{
  const Point chord = wire.back - wire.front;
  const double rise = chord.z() / std::cos(swing * M_PI / 180);
  const double aside = chord.z() * std::tan(swing * M_PI / 180);
  const double squared = chord.head<2>().squaredNorm() - aside * aside;
  return {std::sqrt(std::max(0.0, squared)), rise};
}

} // namespace

Catenary
catenaryBetween(const Point& front, const Point& back, double a, double swing)
{
  const double phi = swing * M_PI / 180;
  const Point chord = back - front;
  const double plan = chord.head<2>().norm();
  // The chord lies in the swung plane: the sideways part of its rise turns the axis.
  const double aside = chord.z() * std::tan(phi);
  const double along = std::sqrt(std::max(0.0, plan * plan - aside * aside));
  const double rise = chord.z() / std::cos(phi);
  Catenary curve;
  curve.a = a;
  curve.swing = swing;
  curve.azimuth = (std::atan2(chord.x(), chord.y()) -
                   std::asin(std::clamp(aside / plan, -1.0, 1.0))) *
                  180 / M_PI;
  curve.azimuth = std::fmod(curve.azimuth + 720, 360);
  const double length = std::hypot(rise, 2 * a * std::sinh(along / (2 * a)));
  const double middle = a * std::atanh(rise / length);
  curve.from = middle - along / 2;
  curve.to = middle + along / 2;
  curve.lowest = Point::Zero();
  curve.lowest = front - curve.at(curve.from);
  return curve;
}

StateOfWires
moveToState(const PowerLineNetwork& network,
            const StateSettings& settings,
            const ConductorState& state,
            double side)
{
  const double load = loadOf(settings.conductor, {}).vertical;
  const ConductorLoad new_load = loadOf(settings.conductor, state);
  // A catenary's swing points from its vertex to its ends, opposite to the belly.
  const double swing = new_load.swing() * (side < 0 ? 1 : -1);
  const double warming =
      state.temperature - settings.measured_temperature + settings.conductor.creep;
  StateOfWires result;
  result.wires = network.wires;
  for (Wire& wire : result.wires)
    wire.ground = wire.vegetation = Clearance();
  for (const std::vector<Link>& chain : chainsOf(network.wires, settings)) {
    StrainSection section;
    section.circuit = chain.front().wire->circuit;
    std::vector<SpanShape> before, after, level;
    // The mean of the tensions, weighted by their precision. Wind during the scan adds
    // to the weight.
    double weights = 0, known_load = 0;
    for (const Link& link : chain) {
      const Wire& wire = *link.wire;
      section.wires.push_back(wire.id);
      before.push_back(shapeOf(wire, wire.curve.swing));
      after.push_back(shapeOf(wire, swing));
      level.push_back({wire.span_length, 0});
      const double weight = 1 / (deviation(wire) * deviation(wire));
      const double own = load / std::cos(wire.curve.swing * M_PI / 180);
      section.tension += weight * wire.curve.a * own;
      known_load += weight * own;
      weights += weight;
    }
    section.tension /= weights;
    known_load /= weights;
    section.ruling_span = rulingSpan(level);
    section.new_tension = tensionAfter(before,
                                       after,
                                       settings.conductor,
                                       section.tension,
                                       known_load,
                                       new_load.resultant(),
                                       warming);
    const double mean = section.tension / known_load,
                 new_mean = section.new_tension / new_load.resultant();
    for (const Link& link : chain) {
      Wire& wire = result.wires[static_cast<std::size_t>(link.wire->id) - 1];
      wire.curve =
          catenaryBetween(wire.front, wire.back, wire.curve.a * new_mean / mean, swing);
      wire.length = wire.sag = 0;
      const Points vertices = polyline(wire);
      for (std::size_t k = 1; k < vertices.size(); ++k)
        wire.length += (vertices[k] - vertices[k - 1]).norm();
      for (int k = 1; k < 64; ++k) {
        const double part = k / 64.0;
        const double chord = wire.front.z() + part * (wire.back.z() - wire.front.z());
        const double s = wire.curve.from + part * (wire.curve.to - wire.curve.from);
        wire.sag = std::max(wire.sag, chord - wire.curve.at(s).z());
      }
    }
    result.sections.push_back(std::move(section));
  }
  return result;
}

} // namespace linelet::powerline
