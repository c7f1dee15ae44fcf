// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include <linelet/io/cloud.h>
#include <linelet/powerline/power_line_network.h>

namespace linelet::test {

/** \brief Two spans over flat ground at z = 0 with three pylons 20 m high at x = 0, 100
 * and 200; two wires in the first span (y = -3, 3), one in the second. The second wire
 * comes within 3 m of a tree and is doubtful. */
inline powerline::PowerLineNetwork
networkByHand()
{
  using namespace powerline;
  PowerLineNetwork network;
  const auto addWire = [&](double x, double y, int span, int number) {
    Wire wire;
    wire.id = static_cast<int>(network.wires.size()) + 1;
    wire.span = span;
    wire.circuit = 1;
    wire.number = number;
    wire.curve.a = 800;
    wire.curve.azimuth = 90; // east
    wire.curve.from = -50;
    wire.curve.to = 50;
    wire.curve.lowest =
        Point(x + 50, y, 20 - 800 * (std::cosh(50.0 / 800) - 1)); // ends 20 m high
    wire.front = wire.curve.at(-50);
    wire.back = wire.curve.at(50);
    wire.front_support = span;
    wire.back_support = span + 1;
    wire.points = 4;
    wire.rms = 0.04;
    wire.length = 1600 * std::sinh(50.0 / 800);
    wire.span_length = 100;
    wire.sag = 20 - wire.curve.lowest.z();
    wire.largest_gap = 2;
    wire.ground.distance = wire.curve.lowest.z();
    wire.ground.wire = wire.curve.lowest;
    wire.ground.other = Point(x + 50, y, 0);
    network.wires.push_back(wire);
  };
  addWire(0, 3, 1, 1);
  addWire(0, -3, 1, 2);
  addWire(100, 3, 2, 1);
  Wire& near = network.wires[1];
  near.vegetation.distance = 3;
  near.vegetation.wire = near.curve.at(10);
  near.vegetation.other = near.vegetation.wire - Point(0, 0, 3);
  near.confidence = 0.4;
  near.reason = "few points < 1 per meter & a hole";
  for (int id = 1; id <= 2; ++id) {
    Span span;
    span.id = span.number = id;
    span.circuit = 1;
    span.from_support = id;
    span.to_support = id + 1;
    span.length = 100;
    span.azimuth = 90;
    span.wires = id == 1 ? std::vector<int>{1, 2} : std::vector<int>{3};
    network.spans.push_back(span);
  }
  for (int id = 1; id <= 3; ++id) {
    Support support;
    support.id = id;
    support.kind = id == 3 ? Support::Kind::Pole : Support::Kind::Pylon;
    support.base = Point(100 * (id - 1), 0, 0);
    support.top = support.base + Point(0, 0, 24);
    support.height = 24;
    support.points = id == 1 ? 1 : 0;
    network.supports.push_back(support);
  }
  network.circuits.push_back({1, {1, 2}, {1, 2, 3}});
  network.ground.cell = 200;
  network.ground.x = 0;
  network.ground.y = -100;
  network.ground.columns = 2;
  network.ground.rows = 2;
  network.ground.heights = {0, 0, 0, 0};
  return network;
}

/** \brief Points of that line far from the origin, with attributes: 12 on the wires,
 * one on pylon 1, two on the tree, 40 on the ground; labels go into \a network. */
inline io::Cloud
cloudByHand(powerline::PowerLineNetwork& network)
{
  io::Cloud cloud;
  cloud.shift = Point(565000, 5930000, 100);
  const auto label = [&](const Point& p, std::uint8_t found, int wire) {
    cloud.points.push_back(p);
    network.classes.push_back(found);
    network.wire_id.push_back(wire);
    network.span_id.push_back(
        wire > 0 ? network.wires[static_cast<std::size_t>(wire) - 1].span : 0);
    network.wire_distance.push_back(wire > 0 ? 0.25F : NAN);
  };
  for (const powerline::Wire& wire : network.wires)
    for (const double s : {-40.0, -10.0, 20.0, 45.0})
      label(wire.curve.at(s) + Point(0, 0.25, 0), powerline::wire_class, wire.id);
  label(Point(0.5, 0, 12), powerline::pylon_class, 0);
  label(network.wires[1].vegetation.other, 0, 0);
  label(network.wires[1].vegetation.other - Point(0, 0, 4), 0, 0);
  for (int i = 0; i < 40; ++i)
    label(Point(5 * i, 8 * std::sin(i), 0), 0, 0);
  const std::size_t n = cloud.points.size();
  std::vector<std::uint8_t> classes(n, 1);
  std::vector<std::uint16_t> intensity(n);
  std::vector<double> time(n);
  for (std::size_t i = 0; i < n; ++i) {
    intensity[i] = static_cast<std::uint16_t>(i * 1000);
    time[i] = 3e8 + 0.125 * static_cast<double>(i);
    classes[i] = i < 13 ? 1 : i < 15 ? 5 : 2;
  }
  cloud.set({"classification", classes, ""});
  cloud.set({"intensity", intensity, ""});
  cloud.set({"gps_time", time, ""});
  return cloud;
}

} // namespace linelet::test
