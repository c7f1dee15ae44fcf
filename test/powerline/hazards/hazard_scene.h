// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include <linelet/powerline/find_hazards.h>
#include <linelet/powerline/hazards_at_states.h>

namespace linelet::test {

using namespace linelet::powerline;

/** Flat or tilted ground around the origin. */
inline Ground
plane(double slope_x = 0, double height = 0)
{
  Ground ground;
  ground.cell = 400;
  ground.x = ground.y = -400;
  ground.columns = ground.rows = 3;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      ground.heights.push_back(
          static_cast<float>(height + slope_x * (-400 + 400 * column)));
  return ground;
}

inline Wire&
addWire(PowerLineNetwork& network,
        const Point& front,
        const Point& back,
        double a,
        int circuit,
        double swing = 0)
{
  Wire wire;
  wire.id = static_cast<int>(network.wires.size()) + 1;
  wire.span = wire.id;
  wire.circuit = circuit;
  wire.curve = catenaryBetween(front, back, a, swing);
  wire.front = front;
  wire.back = back;
  wire.span_length = (back - front).head<2>().norm();
  wire.sag = wire.span_length * wire.span_length / (8 * a);
  network.wires.push_back(wire);
  while (static_cast<int>(network.circuits.size()) < circuit)
    network.circuits.push_back({static_cast<int>(network.circuits.size()) + 1, {}, {}});
  network.circuits[static_cast<std::size_t>(circuit) - 1].spans.push_back(wire.span);
  return network.wires.back();
}

inline void
stand(Surroundings& around, const Point& p, HazardKind kind, int support = 0)
{
  around.points.push_back(p);
  around.kinds.push_back(kind);
  around.support.push_back(support);
}

inline std::vector<Encroachment>
ofKind(const Hazards& hazards, HazardKind kind)
{
  std::vector<Encroachment> found;
  for (const Encroachment& one : hazards.clearances)
    if (one.kind == kind)
      found.push_back(one);
  return found;
}

/** A cloud with a wire 12 m high, and whatever else \a fill adds. */
struct Scene {
  PowerLineNetwork network;
  io::Cloud cloud;
  std::vector<std::uint8_t> classes, returns;

  Scene()
  {
    network.ground = plane();
    addWire(network, Point(-50, 0, 12), Point(50, 0, 12), 3000, 1);
  }

  void
  add(const Point& p, int given, int echoes = 1)
  {
    cloud.points.push_back(p);
    classes.push_back(static_cast<std::uint8_t>(given));
    returns.push_back(static_cast<std::uint8_t>(echoes));
    network.classes.push_back(static_cast<std::uint8_t>(given));
    network.wire_id.push_back(0);
  }

  Hazards
  hazards(double clearance = 5)
  {
    cloud.set({"classification", classes, ""});
    cloud.set({"number_of_returns", returns, ""});
    const io::UsablePoints usable(cloud);
    const ClearanceLimits limits = uniformLimits(clearance);
    return findHazards(
        network, findSurroundings(network, cloud, usable, limits), limits);
  }
};

} // namespace linelet::test
