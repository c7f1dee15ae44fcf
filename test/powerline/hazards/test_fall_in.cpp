// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <random>
#include <vector>

#include "hazard_scene.h"
#include "random_seed.h"

namespace {

using namespace linelet;
using namespace linelet::test;

// A tree standing 6 m higher up the slope reaches the wire; the same tree as far down
// the slope does not.
TEST(FallIn, TurnsAboutTheFootOnTheTerrain)
{
  PowerLineNetwork network;
  network.ground = plane(0.5);
  addWire(network, Point(0, -100, 15), Point(0, 100, 15), 5000, 1);
  Surroundings around;
  for (const double x : {12.0, -12.0})
    for (int k = 0; k <= 30; ++k) // a crown of a cone
      for (int j = 0; j < 6; ++j)
        stand(around,
              Point(x + 0.04 * (30 - k) * std::cos(j),
                    10 + 0.04 * (30 - k) * std::sin(j),
                    0.5 * x + 8 + 0.3 * k),
              HazardKind::Vegetation);
  const Hazards hazards = findHazards(network, around, uniformLimits(3));
  ASSERT_EQ(hazards.fall_in.size(), 1U);
  const FallIn& tree = hazards.fall_in[0];
  EXPECT_NEAR(tree.top.x(), 12, 1e-9);
  EXPECT_NEAR(tree.height, 17, 1e-6);
  const double distance = std::hypot(12, network.wires[0].curve.lowest.z() - 6);
  EXPECT_NEAR(tree.distance, distance, 0.02);
  EXPECT_NEAR(tree.gap, distance - 17, 0.02);
  EXPECT_EQ(tree.severity, Severity::High);
  EXPECT_EQ(tree.wire, 1);
}

TEST(FallIn, CountsATreeOnceAndNoBuilding)
{
  std::mt19937 random(randomSeed());
  std::uniform_real_distribution<double> one(-1, 1);
  PowerLineNetwork network;
  network.ground = plane();
  addWire(network, Point(-100, 0, 12), Point(100, 0, 12), 3000, 1);
  Surroundings around;
  std::size_t trees = 0;
  for (double x = -80; x <= 80; x += 16, ++trees) {
    for (int k = 0; k < 400; ++k) {
      const Point d(one(random), one(random), one(random));
      if (d.norm() < 1) // crowns of 2 m radius
        stand(around,
              Point(x, 9, 12) + Point(2 * d.x(), 2 * d.y(), 4 * d.z()),
              HazardKind::Vegetation);
    }
    stand(around, Point(x, 9, 16.2), HazardKind::Vegetation);
  }
  for (int k = 0; k < 100; ++k)
    stand(around, Point(0.2 * k, -9, 15), HazardKind::Building);
  EXPECT_EQ(findHazards(network, around, uniformLimits(1)).fall_in.size(), trees);
}

// Bushes, 4 m by 10 m, with their top 3 m below the wire: 5 m around the wire reach
// down to 5 m below it in the middle, less to the sides.
TEST(Cut, AreaAndVolumeAreThoseOfTheBlockWithinTheLimit)
{
  PowerLineNetwork network;
  network.ground = plane();
  addWire(network, Point(-100, 0, 20), Point(100, 0, 20), 1e6, 1); // straight
  const double wire_z = network.wires[0].curve.lowest.z();
  Surroundings around;
  for (double x = -5; x < 5; x += 0.125)
    for (double y = -2; y < 2; y += 0.125)
      for (double z = wire_z - 8; z <= wire_z - 3 + 1e-9; z += 0.25)
        stand(around, Point(x + 0.01, y + 0.01, z), HazardKind::Vegetation);
  const std::vector<Encroachment> found =
      ofKind(findHazards(network, around, uniformLimits(5)), HazardKind::Vegetation);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0].area, 40, 1e-9);
  double volume = 0; // integral of the depth of the tube below the top
  for (double y = -1.995; y < 2; y += 0.01)
    volume += 10 * 0.01 * (std::sqrt(25 - y * y) - 3);
  EXPECT_NEAR(found[0].volume, volume, 0.1 * volume);
  EXPECT_NEAR(found[0].nearest.distance, 3, 0.01);
  // 5 m around the ends, 4 m of them along the wire.
  EXPECT_NEAR(found[0].length, 10 + 2 * 4, 0.2);
}

} // namespace
