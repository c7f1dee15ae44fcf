// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// Lines that are not wires are reported, and nothing else.

#include <algorithm>
#include <cstddef>
#include <numeric>

#include <gtest/gtest.h>

#include <linelet/powerline/extract_power_lines.h>

#include "powerline/scene_builder.h"

namespace linelet::powerline {
namespace {

using test::SceneBuilder;

SceneBuilder
lineOverField()
{
  SceneBuilder scene(9);
  scene.ground(0, 0, 160, 60, 5);
  for (const double y : {28.0, 30.0, 32.0})
    scene.wire({0, y, 16}, {160, y, 16}, 1200, 4, 0.03);
  return scene;
}

TEST(Unexplained, NothingIsWhereEveryLineIsAWire)
{
  const PowerLineNetwork network = extractPowerLines(lineOverField().points);
  EXPECT_EQ(network.wires.size(), 3u);
  EXPECT_TRUE(network.unexplained.empty());
  EXPECT_EQ(std::count(network.is_unexplained.begin(), network.is_unexplained.end(), 1),
            0);
  EXPECT_FALSE(muchIsUnexplained(network));
}

// A pipe has no sag and is not a wire, but nobody should have to find it by eye.
TEST(Unexplained, AStraightPipeIsReported)
{
  SceneBuilder scene = lineOverField();
  const std::size_t before = scene.points.size();
  constexpr double length = 90;
  for (int i = 0; i < 4 * length; ++i)
    scene.points.emplace_back(
        20 + scene.uniform(0, length), 10 + scene.normal(0.02), 7 + scene.normal(0.02));
  const PowerLineNetwork network = extractPowerLines(scene.points);
  EXPECT_EQ(network.wires.size(), 3u);
  EXPECT_NEAR(unexplainedLength(network), length, 4);
  EXPECT_TRUE(muchIsUnexplained(network));
  ASSERT_FALSE(network.unexplained.empty());
  EXPECT_NEAR(network.unexplained[0].width, 0.02, 0.02);
  ASSERT_EQ(network.is_unexplained.size(), scene.points.size());
  const auto of_pipe =
      network.is_unexplained.begin() + static_cast<std::ptrdiff_t>(before);
  EXPECT_GT(std::accumulate(of_pipe, network.is_unexplained.end(), 0),
            4 * length * 0.95);
  EXPECT_EQ(std::accumulate(network.is_unexplained.begin(), of_pipe, 0), 0);
}

TEST(Unexplained, IsEmptyInAnEmptyScene)
{
  const PowerLineNetwork network = extractPowerLines(Points());
  EXPECT_TRUE(network.unexplained.empty());
  EXPECT_FALSE(muchIsUnexplained(network));
}

} // namespace
} // namespace linelet::powerline
