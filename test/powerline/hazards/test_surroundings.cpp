// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "hazard_scene.h"
#include "random_seed.h"

namespace {

using namespace linelet;
using namespace linelet::test;

TEST(Surroundings, BirdsAndNoiseAreNotHazards)
{
  Scene scene;
  for (int k = 0; k < 20; ++k) { // a swarm of class 18, and of class 7 below
    scene.add(Point(0.1 * k, 0.3, 10), 18);
    scene.add(Point(0.1 * k, -0.3, 9), 7);
  }
  scene.add(Point(20, 0, 10), 1); // an unclassified bird
  scene.add(Point(20.3, 0, 10.1), 1);
  EXPECT_TRUE(scene.hazards().clearances.empty());
  for (int k = 0; k < 20; ++k)
    scene.add(Point(-30 + 0.1 * k, 0.3 * (k % 3), 9 + 0.3 * (k % 2)), 5);
  const Hazards with_tree = scene.hazards();
  ASSERT_EQ(with_tree.clearances.size(), 1U);
  EXPECT_EQ(with_tree.clearances[0].kind, HazardKind::Vegetation);
}

// A pole's head without classes: crossarm, insulators and whatever hangs from them are
// not vegetation near the wires they carry, but a tree beside them is.
TEST(Surroundings, SupportsAreNotHazardsToTheirWires)
{
  Scene scene;
  Support pole;
  pole.id = 1;
  pole.kind = Support::Kind::Pole;
  pole.base = Point(-50, 1.2, 0);
  pole.top = Point(-50, 1.2, 12.5);
  scene.network.supports.push_back(pole);
  scene.network.wires[0].front_support = 1;
  for (int k = 0; k < 60; ++k)
    scene.add(Point(-50 + 0.2 * (k % 3), 0.02 * k, 11.3 + 0.1 * (k % 9)), 1);
  EXPECT_TRUE(scene.hazards().clearances.empty());
  for (int k = 0; k < 300; ++k)
    scene.add(Point(-44 + 0.3 * (k % 7), 0.3 * (k % 5), 6 + 0.02 * (k % 150)), 1, 2);
  EXPECT_EQ(scene.hazards().clearances.size(), 1U);
}

TEST(Surroundings, OtherSchemesOfClassesAreUnderstood)
{
  Scene scene;
  for (int k = 0; k < 20; ++k)
    scene.add(Point(0.1 * k, 0.3 * (k % 3), 9 + 0.3 * (k % 2)), 19);
  scene.cloud.set({"classification", scene.classes, ""});
  const io::UsablePoints usable(scene.cloud);
  HazardSettings settings;
  settings.classes.buildings = io::ClassList("19");
  const std::vector<Hazards> found =
      findHazardsAtStates(scene.network, scene.cloud, usable, settings, 5);
  ASSERT_EQ(found[0].clearances.size(), 1U);
  EXPECT_EQ(found[0].clearances[0].kind, HazardKind::Building);
}

TEST(Surroundings, RoofsAndCrownsAreDistinguishedByClassOrShape)
{
  for (const bool with_classes : {true, false}) {
    SCOPED_TRACE(testing::Message() << "classes " << with_classes);
    std::mt19937 random(randomSeed());
    std::uniform_real_distribution<double> one(-1, 1);
    Scene scene;
    for (int k = 0; k < 1500; ++k) { // a pitched roof of 10 m by 8 m
      const double y = 4 * one(random);
      scene.add(
          Point(-25 + 5 * one(random), y, 9 - 0.5 * std::abs(y) + 0.02 * one(random)),
          with_classes ? 6 : 1);
    }
    for (int k = 0; k < 3000; ++k) { // a crown of 3 m radius
      const Point d(one(random), one(random), one(random));
      if (d.norm() < 1)
        scene.add(Point(25, 0, 6) + 3 * d, with_classes ? 5 : 1, 1 + k % 3);
    }
    for (const Encroachment& e : scene.hazards().clearances) {
      const bool house = e.nearest.other.x() < 0;
      EXPECT_EQ(e.kind, house ? HazardKind::Building : HazardKind::Vegetation)
          << e.nearest.other.transpose();
    }
    EXPECT_EQ(scene.hazards().clearances.size(), 2U);
  }
}

TEST(Hazards, OfNothingAreNone)
{
  const ClearanceLimits limits = uniformLimits(5);
  EXPECT_TRUE(findHazards({}, {}, limits).clearances.empty());
  PowerLineNetwork network; // no ground, a wire without length, a non-finite point
  addWire(network, Point(0, 0, 10), Point(0, 1e-9, 10), 1000, 1);
  Surroundings around;
  stand(around,
        Point::Constant(std::numeric_limits<double>::quiet_NaN()),
        HazardKind::Vegetation);
  EXPECT_NO_THROW(findHazards(network, around, limits));
  Scene scene;
  scene.network.ground = Ground();
  scene.add(Point::Constant(std::numeric_limits<double>::quiet_NaN()), 5);
  scene.add(Point(0, 0, 10), 5);
  EXPECT_TRUE(scene.hazards().clearances.empty());
}

} // namespace
