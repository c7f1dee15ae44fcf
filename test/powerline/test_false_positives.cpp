// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>

#include <gtest/gtest.h>

#include <linelet/powerline/extract_power_lines.h>

#include "scene_builder.h"

namespace linelet::powerline {
namespace {

using test::SceneBuilder;

SceneBuilder
field(std::uint32_t seed)
{
  SceneBuilder scene(seed);
  scene.ground(0, 0, 140, 60, 5);
  return scene;
}

/** Points along a straight bar, with 2 cm of noise. */
void
bar(SceneBuilder& scene, const Point& from, const Point& to, double per_meter)
{
  const double count = (to - from).norm() * per_meter;
  for (int i = 0; i < static_cast<int>(count); ++i)
    scene.points.push_back(
        from + scene.uniform(0, 1) * (to - from) +
        Point(scene.normal(0.02), scene.normal(0.02), scene.normal(0.02)));
}

// A bar has no sag, a wire between the same points does: only that tells them apart.
TEST(FalsePositives, AStraightBarIsNotAWireButASaggingOneIs)
{
  const Point from(20, 30, 14), to(110, 32, 14.5);
  SceneBuilder straight = field(1), hanging = field(1);
  bar(straight, from, to, 4);
  EXPECT_TRUE(extractPowerLines(straight.points).wires.empty());
  hanging.wire(from, to, 900, 4, 0.02);
  const PowerLineNetwork n = extractPowerLines(hanging.points);
  ASSERT_EQ(n.wires.size(), 1U);
  EXPECT_NEAR(n.wires[0].length, 90, 2);
}

// Guys run from a mast to the ground, and two of them may meet at the mast like the
// wires of two spans.
TEST(FalsePositives, TheGuysOfAMastAreNotWires)
{
  SceneBuilder scene = field(5);
  for (double z = 0; z < 32; z += 0.2)
    scene.points.emplace_back(70 + scene.normal(0.1), 30 + scene.normal(0.1), z);
  for (const double x : {42, 98})
    scene.wire({70, 30, 30}, {x, 30., 0}, 900, 4, 0.02);
  EXPECT_TRUE(extractPowerLines(scene.points).wires.empty());
}

// Pipes are cut at their posts, and the pieces meet like wires at supports.
TEST(FalsePositives, APipeBridgeCutOffByTheBorderIsNotALine)
{
  for (const std::uint32_t seed : {1, 2, 3}) {
    SceneBuilder scene = field(seed);
    for (const double y : {29.2, 29.9, 30.8, 31.4})
      for (int i = 0; i < 34 * 3; ++i)
        scene.points.emplace_back(
            scene.uniform(0, 34), y + scene.normal(0.05), 7 + scene.normal(0.05));
    for (double x = 9; x < 36; x += 12)
      for (const double y : {29.0, 31.6})
        bar(scene, {x, y, 0}, {x, y, 7}, 8);
    EXPECT_TRUE(extractPowerLines(scene.points).wires.empty()) << "seed " << seed;
  }
}

// Even where the data end beyond it, which excuses much.
TEST(FalsePositives, TheChordsOfAJibAreNotWires)
{
  SceneBuilder scene = field(2);
  for (const double y : {29.4, 30.6})
    for (const double z : {30.0, 31.2})
      bar(scene, {0, y, z}, {60, y, z}, 4);
  for (double x = 0; x < 60; x += 1.5) {
    bar(scene, {x, 29.4, 30}, {x + 1.5, 30.6, 30}, 3);
    bar(scene, {x, 30.6, 30}, {x + 1.5, 30.6, 31.2}, 3);
  }
  EXPECT_TRUE(extractPowerLines(scene.points).wires.empty());
}

// The rails sag with the terrain, but the fence fills the space down to the ground.
TEST(FalsePositives, ATallFenceIsNotALineButOneAboveItIs)
{
  SceneBuilder scene = field(3);
  const auto fence = [&](double height) {
    for (double z = 0.6; z <= height; z += 0.6)
      scene.wire({10, 20, z}, {100, 20, z}, 2500, 4, 0.02);
    for (double x = 10; x <= 100; x += 2.5)
      bar(scene, {x, 20, 0}, {x, 20, height}, 6);
  };
  fence(5.4);
  EXPECT_TRUE(extractPowerLines(scene.points).wires.empty());
  scene.wire({5, 21, 11}, {115, 21, 11}, 700, 4, 0.02);
  EXPECT_EQ(extractPowerLines(scene.points).wires.size(), 1U);
}

TEST(FalsePositives, TheRailingOfARoofIsNotAWire)
{
  SceneBuilder scene = field(4);
  scene.box({50, 20, 12}, {74, 40, 12.05}, 24 * 20 * 8);
  for (const double z : {12.6, 13.1}) {
    bar(scene, {50, 20, z}, {74, 20, z}, 4);
    bar(scene, {50, 40, z}, {74, 40, z}, 4);
  }
  EXPECT_TRUE(extractPowerLines(scene.points).wires.empty());
}

TEST(FalsePositives, ABranchLineAtAPoleIsNotACrossarm)
{
  SceneBuilder scene = field(5);
  for (const double y : {29.5, 30.5}) {
    scene.wire({10, y, 9}, {50, y, 9}, 300, 4, 0.02);
    scene.wire({50, y, 9}, {90, y, 9}, 300, 4, 0.02);
  }
  for (const double x : {49.5, 50.5})
    scene.wire({x, 30, 9}, {x, 56, 9}, 250, 4, 0.02);
  bar(scene, {50, 30, 0}, {50, 30, 9}, 8);
  std::size_t along_y = 0;
  for (const Wire& wire : extractPowerLines(scene.points).wires)
    along_y += std::abs((wire.back - wire.front).y()) > 20;
  EXPECT_EQ(along_y, 2U);
}

// Two conductors of 0.8 points per meter, 3 m apart, do not look linear around their
// points: they are found by the shape of the wire beside them.
TEST(ParallelWires, OfAThinScanAreFoundByTheirNeighbor)
{
  SceneBuilder scene(6);
  scene.ground(0, 0, 260, 60, 2);
  scene.wire({0, 30, 30}, {250, 30, 30}, 1500, 3, 0.05);
  for (const double y : {24.0, 27.0, 33.0, 36.0})
    scene.wire({0, y, 22}, {250, y, 22}, 1500, 0.8, 0.08);
  const PowerLineNetwork n = extractPowerLines(scene.points);
  std::size_t whole = 0;
  for (const Wire& wire : n.wires)
    whole += wire.length > 230;
  EXPECT_EQ(whole, 5U);
  EXPECT_EQ(n.wires.size(), 5U);
}

} // namespace
} // namespace linelet::powerline
