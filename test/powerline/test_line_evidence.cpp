// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// Poles revealed only by all wires of a line together, and clouds that hold nothing but
// the line.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <linelet/powerline/extract_power_lines.h>

#include "powerline/scene_builder.h"

namespace linelet::powerline {
namespace {

using test::SceneBuilder;

/** Four wires over three poles, the middle one lower by \a drop: the slope changes
 * there by 2 drop / span - span / a. The poles are not scanned. */
SceneBuilder
lineWithoutPoles(std::uint32_t seed, double drop, double noise)
{
  constexpr double span = 35, top = 9, a = 400;
  SceneBuilder scene(seed);
  scene.ground(-span - 1, -12, span + 1, 12, 6);
  for (const double y : {-0.75, -0.25, 0.25, 0.75})
    for (const double x : {-span, span})
      scene.wire({x, y, top}, {0, y, top - drop}, a, 3, noise);
  return scene;
}

TEST(KinkOfALine, IsSeenInAllWiresTogether)
{
  // The slope changes by 0.019: one parabola follows each wire over both spans.
  for (const std::uint32_t seed : {1, 2, 3, 4, 5, 6}) {
    const PowerLineNetwork network =
        extractPowerLines(lineWithoutPoles(seed, 1.2, 0.05).points);
    EXPECT_EQ(network.wires.size(), 8u) << "seed " << seed;
    EXPECT_EQ(network.supports.size(), 1u) << "seed " << seed;
    for (const Wire& wire : network.wires)
      EXPECT_LT(std::min(std::abs(wire.front.x()), std::abs(wire.back.x())), 1.5)
          << "seed " << seed;
  }
}

TEST(KinkOfALine, LocatesThePoleFromAllWiresTogether)
{
  // The slope changes by 0.036: enough to cut each wire, too little to locate the cut.
  std::vector<double> off;
  for (const std::uint32_t seed : {1, 2, 3, 4, 5, 6})
    for (const Wire& wire :
         extractPowerLines(lineWithoutPoles(seed, 0.9, 0.05).points).wires)
      off.push_back(std::min(std::abs(wire.front.x()), std::abs(wire.back.x())));
  EXPECT_EQ(off.size(), 6 * 8u);
  std::sort(off.begin(), off.end());
  EXPECT_LT(off[off.size() / 2], 0.2);
  EXPECT_LT(off[off.size() - 2], 0.5);
}

TEST(KinkOfALine, IsNotInventedInOneSpan)
{
  for (const std::uint32_t seed : {1, 2, 3, 4}) {
    SceneBuilder scene(seed);
    scene.ground(-36, -12, 36, 12, 6);
    for (const double y : {-0.75, -0.25, 0.25, 0.75})
      scene.wire({-35, y, 9}, {35, y, 9}, 400, 3, 0.05);
    EXPECT_EQ(extractPowerLines(scene.points).wires.size(), 4u) << "seed " << seed;
  }
}

/** A pylon line of two spans: its lowest wires are the lowest points nearly
 * everywhere. */
SceneBuilder
pylonLine(bool with_ground)
{
  SceneBuilder scene(3);
  if (with_ground)
    scene.ground(-90, -15, 90, 15, 4);
  scene.pylon({0, 0, 0}, 32);
  for (const auto& [y, z] : {std::pair(-6., 20.), {6., 20.}, {-5., 26.}, {5., 26.}})
    for (const double x : {-90., 90.})
      scene.wire({x, y, z}, {0, y, z}, 900, 4, 0.03);
  return scene;
}

TEST(OnlyTheLine, GivesTheSameWiresAsWithItsSurroundings)
{
  const PowerLineNetwork all = extractPowerLines(pylonLine(true).points);
  const PowerLineNetwork kept = extractPowerLines(pylonLine(false).points);
  ASSERT_EQ(all.wires.size(), 8u);
  ASSERT_EQ(kept.wires.size(), 8u);
  ASSERT_EQ(kept.supports.size(), 1u);
  EXPECT_NEAR(kept.supports[0].base.z(), 0, 0.5); // its lowest point
}

TEST(OnlyTheLine, HasUnknownClearancesAndHeights)
{
  SceneBuilder scene = pylonLine(false);
  scene.box({40, 5.2, 18.4}, {42, 6.8, 19}, 20); // spacers, for example: not vegetation
  const PowerLineNetwork network = extractPowerLines(scene.points);
  ASSERT_FALSE(network.wires.empty());
  EXPECT_TRUE(network.ground.heights.empty());
  for (const Wire& wire : network.wires) {
    EXPECT_FALSE(wire.ground.known());
    EXPECT_FALSE(wire.vegetation.known());
  }
  for (const Support& support : network.supports)
    EXPECT_TRUE(std::isnan(support.height));
}

TEST(OnlyTheLine, IsKnownByItsClassesWhereWiresHangTooNearEachOther)
{
  // Four wires half a meter apart look like a narrow surface.
  SceneBuilder scene(5);
  for (const double y : {-0.75, -0.25, 0.25, 0.75})
    scene.wire({-40, y, 9}, {40, y, 9}, 400, 8, 0.02);
  const std::vector<std::uint8_t> classes(scene.points.size(), wire_class);
  EXPECT_EQ(extractPowerLines(scene.points, classes).wires.size(), 4u);
}

} // namespace
} // namespace linelet::powerline
