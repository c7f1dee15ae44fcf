// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <vector>

#include "hazard_scene.h"

namespace {

using namespace linelet;
using namespace linelet::test;

TEST(OtherLines, CrossWithTheDistancesOfBruteForce)
{
  PowerLineNetwork network;
  network.ground = plane();
  addWire(network, Point(-150, 0, 40), Point(150, 10, 42), 1200, 1);
  addWire(network, Point(20, -60, 28), Point(10, 60, 36), 500, 2);
  addWire(network, Point(-150, 8, 40), Point(150, 18, 42), 1200, 1); // the same line
  const Hazards hazards = findHazards(network, {}, uniformLimits(7));
  ASSERT_EQ(hazards.crossings.size(), 2U);
  const Crossing& found = hazards.crossings[0];
  EXPECT_EQ(found.upper, 1);
  EXPECT_EQ(found.lower, 2);
  double least = 1e9, plan = 1e9, vertical = 0;
  const Catenary &a = network.wires[0].curve, &b = network.wires[1].curve;
  for (double s = a.from; s <= a.to; s += 0.05)
    for (double t = b.from; t <= b.to; t += 0.05) {
      const Point off = a.at(s) - b.at(t);
      least = std::min(least, off.norm());
      if (off.head<2>().norm() < plan) {
        plan = off.head<2>().norm();
        vertical = off.z();
      }
    }
  EXPECT_NEAR(found.nearest.distance, least, 2e-3);
  EXPECT_NEAR(found.vertical, vertical, 1e-2);
  EXPECT_LT((found.upper_at - found.lower_at).head<2>().norm(), 1e-6);
  EXPECT_GT(found.angle, 80);
  EXPECT_LE(found.angle, 90);
  // The pair is one stretch, on the upper wire.
  const std::vector<Encroachment> near = ofKind(hazards, HazardKind::Wire);
  ASSERT_FALSE(near.empty());
  EXPECT_EQ(near[0].wire, 1);
  EXPECT_EQ(near[0].other, 2);
  EXPECT_NEAR(near[0].nearest.distance, least, 2e-3);
  // Acceptable with a lower limit, but still a crossing.
  const Hazards calm = findHazards(network, {}, uniformLimits(1));
  EXPECT_EQ(calm.crossings.size(), 2U);
  EXPECT_EQ(calm.crossings[0].severity, Severity::None);
  EXPECT_TRUE(calm.clearances.empty());
}

TEST(OtherLines, MeetAtASupportWithoutHazard)
{
  PowerLineNetwork network;
  network.ground = plane();
  addWire(network, Point(-150, 0, 30), Point(0, 0, 30), 1200, 1).back_support = 1;
  addWire(network, Point(0, 0, 30), Point(0, 120, 30), 1200, 2).front_support = 1;
  network.circuits[0].supports = {0, 1};
  network.circuits[1].supports = {1, 0};
  const Hazards hazards = findHazards(network, {}, uniformLimits(5));
  EXPECT_TRUE(hazards.clearances.empty());
  EXPECT_TRUE(hazards.crossings.empty());
}

TEST(OtherLines, TheirSupportsAreHazardsAndOwnOnesAreNot)
{
  PowerLineNetwork network;
  network.ground = plane();
  Wire& wire = addWire(network, Point(-100, 0, 30), Point(100, 0, 30), 1000, 1);
  wire.front_support = 1;
  network.circuits[0].supports = {1, 0};
  Surroundings around;
  for (int k = 0; k < 10; ++k) {
    stand(around, Point(-99, 0.5, 20 + k), HazardKind::Support, 1);
    stand(around, Point(40, 2, 16 + k), HazardKind::Support, 2);
  }
  const Hazards hazards = findHazards(network, around, uniformLimits(5));
  ASSERT_EQ(hazards.clearances.size(), 1U);
  EXPECT_EQ(hazards.clearances[0].kind, HazardKind::Support);
  EXPECT_EQ(hazards.clearances[0].other, 2);
}

} // namespace
