// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include <linelet/powerline/extract_power_lines.h>

#include "powerline/scene_builder.h"

namespace linelet::powerline {
namespace {

using test::SceneBuilder;

/** A tension pylon at the origin, as a drone sees it, with two conductors that end at
 * its arm in strings of 2.5 m on both sides, and loops between these if wanted. */
struct TensionPylon {
  static constexpr double string = 2.5, arm = 0.4, height = 25, sag = 2.4, noise = 0.02;
  SceneBuilder scene{7};
  std::vector<char> is_string, is_loop;

  explicit TensionPylon(bool loops, double per_meter = 40, bool pylon = true)
  {
    scene.ground(-60, -15, 60, 15, 4);
    if (pylon) {
      scene.box({-1, -1, 0}, {1, 1, 29}, 6000);
      scene.box({-arm, -6, height}, {arm, 6, height + 1}, 900);
    }
    const double clamp = arm + string;
    for (const double y : {-5.8, 5.8})
      for (const double side : {-1.0, 1.0}) {
        scene.wire({side * clamp, y, height - 0.2},
                   {side * 60, y, height - 1.5},
                   900,
                   per_meter,
                   noise);
        const std::size_t before = scene.points.size();
        for (int i = 0; i < 2 * per_meter * string; ++i)
          scene.points.emplace_back(side * (arm + scene.uniform(0, string)),
                                    y + scene.uniform(-0.12, 0.12),
                                    height - 0.1 + scene.uniform(-0.12, 0.12));
        mark(is_string, before);
      }
    for (const double y : {-5.8, 5.8})
      if (loops) {
        const std::size_t before = scene.points.size();
        for (int i = 0; i < 2 * per_meter * clamp; ++i)
          scene.points.push_back(
              onLoop(y, scene.uniform(-clamp, clamp)) +
              Point(scene.normal(noise), scene.normal(noise), scene.normal(noise)));
        mark(is_loop, before);
      }
    is_string.resize(scene.points.size(), 0);
    is_loop.resize(scene.points.size(), 0);
  }

  static Point
  onLoop(double y, double x)
  {
    const double t = x / (arm + string);
    return {x, y, height - 0.2 - sag * (1 - t * t)};
  }

private:
  void
  mark(std::vector<char>& marks, std::size_t from) const
  {
    marks.resize(from, 0);
    marks.resize(scene.points.size(), 1);
  }
};

double
share(const std::vector<char>& of, const PowerLineNetwork& n, std::uint8_t number)
{
  double found = 0, all = 0;
  for (std::size_t i = 0; i < of.size(); ++i) {
    all += of[i];
    found += of[i] != 0 && n.classes[i] == number;
  }
  return found / all;
}

TEST(Fittings, LoopsAndStringsOfATensionPylonAreFound)
{
  const TensionPylon truth(true);
  const PowerLineNetwork n = extractPowerLines(truth.scene.points);
  ASSERT_EQ(n.wires.size(), 4u);
  ASSERT_EQ(n.jumpers.size(), 2u);
  for (const Jumper& jumper : n.jumpers) {
    EXPECT_EQ(jumper.id, &jumper - n.jumpers.data() + 1);
    EXPECT_EQ(jumper.support, 1);
    // It connects the two wires on its side.
    const double y = jumper.course.front().y() < 0 ? -5.8 : 5.8;
    for (const int id : {jumper.from_wire, jumper.to_wire}) {
      ASSERT_GT(id, 0);
      EXPECT_NEAR(n.wires[static_cast<std::size_t>(id) - 1].front.y(), y, 0.5);
    }
    EXPECT_NE(jumper.from_wire, jumper.to_wire);
    EXPECT_NEAR(jumper.sag, TensionPylon::sag, 0.4);
    EXPECT_LT(jumper.rms, 0.1);
    // Every point of the loop that is clear of the strings has a vector near it.
    for (double x = -2.2; x <= 2.2; x += 0.2) {
      double nearest = 9;
      for (std::size_t v = 1; v < jumper.course.size(); ++v)
        for (double t = 0; t <= 1; t += 0.05)
          nearest = std::min(nearest,
                             (jumper.course[v - 1] +
                              t * (jumper.course[v] - jumper.course[v - 1]) -
                              TensionPylon::onLoop(y, x))
                                 .norm());
      EXPECT_LT(nearest, 0.15) << x;
    }
  }
  ASSERT_EQ(n.insulators.size(), 4u);
  for (const InsulatorString& string : n.insulators) {
    EXPECT_EQ(string.kind, InsulatorString::Kind::Tension);
    EXPECT_EQ(string.support, 1);
    EXPECT_GT(string.wire, 0);
    EXPECT_GT(string.jumper, 0);
    EXPECT_NEAR(string.length, TensionPylon::string, 0.8);
    EXPECT_LT(std::abs(string.structure.x()), std::abs(string.live.x()));
  }
  EXPECT_GE(share(truth.is_loop, n, wire_class), 0.85);
  EXPECT_GE(share(truth.is_string, n, connector_class), 0.75);
  for (std::size_t i = 0; i < n.classes.size(); ++i)
    if (n.classes[i] == connector_class) {
      EXPECT_EQ(n.wire_id[i], 0);
      EXPECT_EQ(n.span_id[i], 0);
      EXPECT_TRUE(std::isnan(n.wire_distance[i]));
    }
}

TEST(Fittings, ThereIsNoJumperWithoutALoop)
{
  const TensionPylon truth(false);
  const PowerLineNetwork n = extractPowerLines(truth.scene.points);
  EXPECT_EQ(n.wires.size(), 4u);
  EXPECT_TRUE(n.jumpers.empty());
}

TEST(Fittings, ThereAreNoneWithoutAPylon)
{
  const TensionPylon truth(true, 40, false);
  const PowerLineNetwork n = extractPowerLines(truth.scene.points);
  EXPECT_TRUE(n.jumpers.empty());
  EXPECT_TRUE(n.insulators.empty());
}

// Three points per meter show wires, but not what hangs at their ends.
TEST(Fittings, ACoarseScanShowsNone)
{
  const TensionPylon truth(true, 3);
  const PowerLineNetwork n = extractPowerLines(truth.scene.points);
  EXPECT_TRUE(n.jumpers.empty());
  EXPECT_TRUE(n.insulators.empty());
}

TEST(Fittings, AWireThatEndsInTheAirHasNone)
{
  SceneBuilder scene(3);
  scene.ground(-60, -15, 60, 15, 4);
  scene.wire({-60, 0, 22}, {0, 0, 20}, 900, 40, 0.02);
  const PowerLineNetwork n = extractPowerLines(scene.points);
  EXPECT_EQ(n.wires.size(), 1u);
  EXPECT_TRUE(n.jumpers.empty());
  EXPECT_TRUE(n.insulators.empty());
}

TEST(Fittings, NothingHasNone)
{
  const PowerLineNetwork n = extractPowerLines(Points{});
  EXPECT_TRUE(n.jumpers.empty());
  EXPECT_TRUE(n.insulators.empty());
}

} // namespace
} // namespace linelet::powerline
