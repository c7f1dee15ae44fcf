// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "hazard_scene.h"
#include "random_seed.h"

namespace {

using namespace linelet;
using namespace linelet::test;

// Every centimeter of the wire that is nearer to a point than the limit lies in a
// stretch, no other does except in gaps of less than a meter, and the nearest distance
// is that of brute force.
TEST(Stretches, AgreeWithBruteForce)
{
  std::mt19937 random(randomSeed());
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
      const Point at = c.at(s);
      for (const Point& p : around.points)
        distance = std::min(distance, (at - p).norm());
      least = std::min(least, distance);
      const bool inside =
          std::any_of(found.begin(), found.end(), [&](const Encroachment& e) {
            return s >= e.from - 0.011 && s <= e.to + 0.011;
          });
      if (distance < limit - 1e-3) {
        ASSERT_TRUE(inside) << s << " at " << distance;
      }
      // Inside a stretch but acceptable: in a gap that was closed.
      if (inside && distance > limit + 1e-3) {
        double nearby = 1e9;
        for (double t = s - 0.51; t <= s + 0.51; t += 0.01) {
          const Point beside = c.at(std::clamp(t, c.from, c.to));
          for (const Point& p : around.points)
            nearby = std::min(nearby, (beside - p).norm());
        }
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
      EXPECT_NEAR(closest_found, least, 5e-3); // brute force has steps, too
    }
    else {
      EXPECT_GT(closest_found, limit - 1e-3);
    }
  }
}

// A wire along a slope: the terrain is nearest to the side, not below.
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
  // Where the plane is 8 m away, the wire is 8 sqrt 2 m above x = 0.
  const double half = c.a * std::acosh(1 + (8 * std::sqrt(2.0) - c.lowest.z()) / c.a);
  EXPECT_NEAR(found.from, -half, 0.05);
  EXPECT_NEAR(found.to, half, 0.05);
  EXPECT_EQ(found.severity,
            uniformLimits(8).severity(HazardKind::Ground, found.nearest.distance));
}

} // namespace
