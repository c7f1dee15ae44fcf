// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <linelet/io/file_error.h>
#include <linelet/powerline/hazards.h>

namespace {

using namespace linelet;
using namespace linelet::powerline;

/** Flat or tilted ground around the origin. */
Ground
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

Wire&
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

void
stand(Surroundings& around, const Point& p, HazardKind kind, int support = 0)
{
  around.points.push_back(p);
  around.kinds.push_back(kind);
  around.support.push_back(support);
}

std::vector<Encroachment>
ofKind(const Hazards& hazards, HazardKind kind)
{
  std::vector<Encroachment> found;
  for (const Encroachment& one : hazards.clearances)
    if (one.kind == kind)
      found.push_back(one);
  return found;
}

// Every centimeter of the wire that a point is nearer to than the limit lies in a
// stretch, no other does but in gaps of less than a meter, and the nearest distance is
// that of brute force.
TEST(Stretches, AgreeWithBruteForce)
{
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> one(-1, 1);
  for (int run = 0; run < 20; ++run) {
    PowerLineNetwork network;
    network.ground = plane();
    const Wire& wire = addWire(network,
                               Point(-100, 20 * one(random), 25),
                               Point(100, 20 * one(random), 25 + 10 * one(random)),
                               700 + 300 * one(random),
                               1,
                               run % 2 == 0 ? 0 : 30 * one(random));
    const double limit = 4 + 2 * one(random);
    Surroundings around;
    for (int tree = 0; tree < 12; ++tree) {
      const Catenary& c = wire.curve;
      const Point beside = c.at(c.from + (0.5 + 0.6 * one(random)) * (c.to - c.from)) +
                           5 * Point(one(random), one(random), one(random) - 1);
      for (int k = 0; k < 30; ++k)
        stand(around,
              beside + 1.5 * Point(one(random), one(random), one(random)),
              HazardKind::Vegetation);
    }
    const Hazards hazards = findHazards(network, around, uniformLimits(limit));
    const std::vector<Encroachment> found = ofKind(hazards, HazardKind::Vegetation);
    double least = 1e9, closest_found = 1e9;
    const Catenary& c = wire.curve;
    for (double s = c.from; s <= c.to; s += 0.01) {
      double distance = 1e9;
      for (const Point& p : around.points)
        distance = std::min(distance, (c.at(s) - p).norm());
      least = std::min(least, distance);
      const bool inside =
          std::any_of(found.begin(), found.end(), [&](const Encroachment& e) {
            return s >= e.from - 0.011 && s <= e.to + 0.011;
          });
      if (distance < limit - 1e-3) {
        ASSERT_TRUE(inside) << s << " at " << distance;
      }
      // In a stretch and yet in order: in a gap that was closed.
      if (inside && distance > limit + 1e-3) {
        double nearby = 1e9;
        for (double t = s - 0.51; t <= s + 0.51; t += 0.01)
          for (const Point& p : around.points)
            nearby = std::min(nearby, (c.at(std::clamp(t, c.from, c.to)) - p).norm());
        ASSERT_LT(nearby, limit + 1e-3) << s;
      }
    }
    for (const Encroachment& e : found) {
      closest_found = std::min(closest_found, e.nearest.distance);
      EXPECT_NEAR((e.nearest.wire - e.nearest.other).norm(), e.nearest.distance, 1e-9);
      EXPECT_NEAR(std::hypot(e.vertical, e.horizontal), e.nearest.distance, 1e-9);
      EXPECT_LT((e.line.front() - c.at(e.from)).norm(), 1e-9);
      EXPECT_LT((e.line.back() - c.at(e.to)).norm(), 1e-9);
      ASSERT_GE(e.outline.size(), 4U);
      EXPECT_EQ(e.outline.front(), e.outline.back());
    }
    if (least < limit - 1e-3) {
      EXPECT_NEAR(closest_found, least, 5e-3); // brute force goes in steps, too
    }
    else {
      EXPECT_GT(closest_found, limit - 1e-3);
    }
  }
}

// A wire along a slope: the terrain is nearest beside it, not below.
TEST(Stretches, DistanceToASlopeIsThatToAPlane)
{
  PowerLineNetwork network;
  network.ground = plane(1.0); // 45 degrees, rising with x
  addWire(network, Point(0, -100, 30), Point(0, 100, 30), 250, 1); // sags 20 m
  const Catenary& c = network.wires[0].curve;
  const Hazards hazards = findHazards(network, {}, uniformLimits(8));
  ASSERT_EQ(hazards.clearances.size(), 1U);
  const Encroachment& found = hazards.clearances[0];
  EXPECT_EQ(found.kind, HazardKind::Ground);
  EXPECT_NEAR(found.nearest.distance, c.lowest.z() / std::sqrt(2.0), 0.02);
  // Where the plane is 8 m away the wire hangs 8 sqrt 2 m over x = 0.
  const double half = c.a * std::acosh(1 + (8 * std::sqrt(2.0) - c.lowest.z()) / c.a);
  EXPECT_NEAR(found.from, -half, 0.05);
  EXPECT_NEAR(found.to, half, 0.05);
  EXPECT_EQ(found.severity,
            uniformLimits(8).severity(HazardKind::Ground, found.nearest.distance));
}

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
  // The pair is one stretch, of the upper wire.
  const std::vector<Encroachment> near = ofKind(hazards, HazardKind::Wire);
  ASSERT_FALSE(near.empty());
  EXPECT_EQ(near[0].wire, 1);
  EXPECT_EQ(near[0].other, 2);
  EXPECT_NEAR(near[0].nearest.distance, least, 2e-3);
  // In order where the limit is lower, but a crossing still.
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

// A tree that stands 6 m higher up the slope reaches the wire; the same tree as far
// down the slope does not.
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
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  std::mt19937 random(seed);
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

// A block of bushes 4 m by 10 m, its top 3 m below the wire: 5 m around the wire reach
// down to 5 m below it in the middle, less beside it.
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

/** A cloud with a wire 20 m high, and what else \a fill adds. */
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

TEST(Surroundings, BirdsAndNoiseAreNoHazard)
{
  Scene scene;
  for (int k = 0; k < 20; ++k) { // a swarm of class 18, and of class 7 below
    scene.add(Point(0.1 * k, 0.3, 10), 18);
    scene.add(Point(0.1 * k, -0.3, 9), 7);
  }
  scene.add(Point(20, 0, 10), 1); // a bird that nobody classified
  scene.add(Point(20.3, 0, 10.1), 1);
  EXPECT_TRUE(scene.hazards().clearances.empty());
  for (int k = 0; k < 20; ++k)
    scene.add(Point(-30 + 0.1 * k, 0.3 * (k % 3), 9 + 0.3 * (k % 2)), 5);
  const Hazards with_tree = scene.hazards();
  ASSERT_EQ(with_tree.clearances.size(), 1U);
  EXPECT_EQ(with_tree.clearances[0].kind, HazardKind::Vegetation);
}

// A pole's head that no class tells: cross-arm, insulators and what hangs off them are
// no vegetation near the wires that they carry, but a tree beside them is.
TEST(Surroundings, WhatCarriesAWireIsNoHazardToIt)
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

TEST(Surroundings, RoofsAndCrownsAreToldApartByClassOrShape)
{
  for (const bool with_classes : {true, false}) {
    const unsigned seed = std::random_device{}();
    SCOPED_TRACE(testing::Message() << "seed " << seed << ", classes " << with_classes);
    std::mt19937 random(seed);
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
  PowerLineNetwork network; // no ground, a wire without length, a point without numbers
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

TEST(Limits, OfTheStandardsRiseWithTheVoltage)
{
  const ClearanceLimits none = uniformLimits(5);
  // EN 50341-1: 5 m + Del but 6 m at least; 1.5 m + Del; 1 m + Dpp.
  const ClearanceLimits high = readLimits("en50341:110", none);
  EXPECT_NEAR(high.of(HazardKind::Ground).high, 6.0, 1e-12);
  EXPECT_NEAR(high.of(HazardKind::Vegetation).medium, 2.5, 1e-12);
  EXPECT_NEAR(high.of(HazardKind::Wire).medium, 2.15, 1e-12);
  EXPECT_NEAR(readLimits("en50341:380", none).of(HazardKind::Ground).high, 7.8, 1e-12);
  // NESC rule 232: 18.5 ft, and 0.4 in a kV above 22 kV to earth.
  EXPECT_NEAR(readLimits("nesc:12", none).of(HazardKind::Ground).high, 5.639, 1e-3);
  EXPECT_NEAR(readLimits("nesc:345", none).of(HazardKind::Ground).high,
              0.3048 * (18.5 + 0.4 / 12 * (345 * 1.05 / std::sqrt(3.0) - 22)),
              1e-9);
  for (const char* name : {"en50341:", "en50341:high", "nesc:1e9", "nesc:-3"})
    EXPECT_THROW(readLimits(name, none), std::invalid_argument) << name;
  for (double voltage = 3; voltage <= 750; voltage += 1)
    for (const char* standard : {"en50341:", "nesc:"})
      for (const ClearanceLimits::Row& row :
           readLimits(standard + std::to_string(voltage), none).rows) {
        ASSERT_LE(row.high, row.medium) << standard << voltage;
        ASSERT_LE(row.medium, row.low) << standard << voltage;
      }
}

TEST(Limits, AreReadFromATableOrRefused)
{
  const std::string path = testing::TempDir() + "linelet_limits.txt";
  std::ofstream(path) << "# meters\nground 6 7 8.5\n\nfall_in 0 1 3 # trees\n";
  const ClearanceLimits limits = readLimits(path, uniformLimits(5));
  EXPECT_EQ(limits.of(HazardKind::Ground).low, 8.5);
  EXPECT_EQ(limits.of(HazardKind::FallIn).low, 3);
  EXPECT_EQ(limits.of(HazardKind::Vegetation).low, 5);
  EXPECT_EQ(limits.severity(HazardKind::Ground, 6.5), Severity::Medium);
  EXPECT_EQ(limits.severity(HazardKind::Ground, 8.5), Severity::None);
  for (const char* bad : {"grund 6 7 8",
                          "ground 6 7",
                          "ground 8 7 6",
                          "ground 6 7 8 9",
                          "ground 6 7 nan",
                          "ground 6 seven 8"}) {
    std::ofstream(path) << "# one\n" << bad << '\n';
    try {
      readLimits(path, uniformLimits(5));
      ADD_FAILURE() << bad;
    }
    catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find("line 2"), std::string::npos) << bad;
    }
  }
  EXPECT_THROW(readLimits("/nowhere/limits", uniformLimits(5)), io::FileError);
}

TEST(States, RunOnInIdsAndLowerTheWiresWithTheHeat)
{
  Scene scene;
  const io::UsablePoints usable(scene.cloud);
  HazardSettings settings;
  settings.limits = "";
  settings.conductor = "Hawk";
  settings.states = {"80C", "0C,wind=500Pa"};
  const std::vector<Hazards> states =
      findHazardsAtStates(scene.network, scene.cloud, usable, settings, 12);
  ASSERT_EQ(states.size(), 4U); // as scanned, hot, wind from both sides
  EXPECT_EQ(states[0].state, "as scanned");
  EXPECT_EQ(states[1].state, "80C");
  EXPECT_TRUE(states[0].moved.wires.empty());
  ASSERT_EQ(states[1].moved.wires.size(), 1U);
  EXPECT_LT(states[1].moved.wires[0].ground.distance, 11);
  int next = 1;
  for (const Hazards& at : states)
    for (const Encroachment& one : at.clearances)
      EXPECT_EQ(one.id, next++);
  EXPECT_GT(next, 4);
  settings.conductor.clear();
  EXPECT_THROW(check(settings), std::invalid_argument);
}

} // namespace
