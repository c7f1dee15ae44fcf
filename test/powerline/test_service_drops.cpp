// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// Short wires from a pole to a house, visible only where neither hides them.

#include <algorithm>
#include <iterator>
#include <vector>

#include <gtest/gtest.h>

#include <linelet/powerline/extract_power_lines.h>

#include "powerline/scene_builder.h"

namespace linelet::powerline {
namespace {

using test::SceneBuilder;

const Point pole(0, 0, 8.5);     // where the line hangs
const Point house(9, -9, 5.5);   // 12.7 m from it in plan
constexpr double drop_sag = 150; // catenary parameter, meters

/** Three wires over a pole, and a house beside it. */
SceneBuilder
lineAndHouse(std::uint32_t seed)
{
  SceneBuilder scene(seed);
  scene.ground(-42, -25, 42, 12, 6);
  for (const double y : {-0.8, 0., 0.8})
    for (const double x : {-40., 40.})
      scene.wire({x, y, 8.5}, {0, y, 8.5}, 400, 4, 0.02);
  scene.box({-0.1, -0.1, 0}, {0.1, 0.1, 8.5}, 60);
  scene.box({9, -20, 5.4}, {17, -9, 5.8}, 700); // its roof
  return scene;
}

/** Wires that do not belong to the line. */
std::vector<Wire>
besideTheLine(const PowerLineNetwork& network)
{
  std::vector<Wire> wires;
  std::copy_if(network.wires.begin(),
               network.wires.end(),
               std::back_inserter(wires),
               [](const Wire& w) { return std::min(w.front.y(), w.back.y()) < -1.5; });
  return wires;
}

TEST(ServiceDrop, IsFoundByTheStretchThatPoleAndHouseLeave)
{
  for (const std::uint32_t seed : {1, 2, 3, 4, 5}) {
    SceneBuilder scene = lineAndHouse(seed);
    // Visible from 2 to 9 m.
    for (int i = 0; i < 20; ++i)
      scene.points.push_back(
          SceneBuilder::onWire(pole, house, drop_sag, scene.uniform(2, 9)) +
          Point(scene.normal(0.02), scene.normal(0.02), scene.normal(0.02)));
    const std::vector<Wire> found = besideTheLine(extractPowerLines(scene.points));
    ASSERT_EQ(found.size(), 1u) << "seed " << seed;
    for (double s = 2; s < 9; s += 0.5)
      EXPECT_LT(found[0].curve.distance(SceneBuilder::onWire(pole, house, drop_sag, s)),
                0.1)
          << "seed " << seed << " at " << s;
    // Extended to both of its supports.
    for (const Point& attachment : {pole, house})
      EXPECT_LT(std::min((found[0].front - attachment).head<2>().norm(),
                         (found[0].back - attachment).head<2>().norm()),
                1.2)
          << "seed " << seed;
  }
}

TEST(ServiceDrop, IsNotWhatPointsAtNoPole)
{
  for (const std::uint32_t seed : {1, 2, 3}) {
    SceneBuilder scene = lineAndHouse(seed);
    const Point far(9, -2, 7);
    for (int i = 0; i < 20; ++i)
      scene.points.push_back(
          SceneBuilder::onWire(far, house, drop_sag, scene.uniform(0, 7)) +
          Point(scene.normal(0.02), scene.normal(0.02), scene.normal(0.02)));
    EXPECT_TRUE(besideTheLine(extractPowerLines(scene.points)).empty())
        << "seed " << seed;
  }
}

TEST(ServiceDrop, IsNotTheGuyOfAPole)
{
  for (const std::uint32_t seed : {1, 2, 3}) {
    SceneBuilder scene = lineAndHouse(seed);
    // Taut, to an anchor 7 m from the pole.
    for (int i = 0; i < 30; ++i) {
      const double part = scene.uniform(0.05, 1);
      scene.points.push_back(pole + part * Point(-5, -5, -8.5) +
                             Point(scene.normal(0.02), scene.normal(0.02), 0));
    }
    EXPECT_TRUE(besideTheLine(extractPowerLines(scene.points)).empty())
        << "seed " << seed;
  }
}

} // namespace
} // namespace linelet::powerline
