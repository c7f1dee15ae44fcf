// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// Lines on poles along streets: racks, whose wires hang closer together than they kink,
// and roofs beside them.

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include <bench/measures/scene_scores.h>
#include <bench/scenes/scene.h>
#include <linelet/powerline/extract_power_lines.h>

#include "powerline/pieces/tangents.h"
#include "powerline/scene_builder.h"

namespace linelet::powerline {
namespace {

constexpr double a = 450; // catenary parameter, meters

/** Slopes along spans of 40 m between level supports, two places a meter. */
std::vector<Tangents::Sample>
slopes(double from, double to, test::SceneBuilder& random)
{
  std::vector<Tangents::Sample> samples;
  for (double s = from; s < to; s += 0.5) {
    const double on = s - 40 * std::floor(s / 40) - 20; // from the middle of a span
    samples.push_back({s, std::sinh(on / a) + random.normal(0.006)});
  }
  return samples;
}

TEST(FindKinks, IsWhereSlopesBreakDownwards)
{
  for (const std::uint32_t seed : {1, 2, 3, 4, 5}) {
    test::SceneBuilder random(seed);
    const std::vector<double> kinks = findKinks(slopes(5, 150, random));
    ASSERT_EQ(kinks.size(), 3U) << "seed " << seed;
    for (std::size_t k = 0; k < kinks.size(); ++k)
      EXPECT_NEAR(kinks[k], 40. * static_cast<double>(k + 1), 3) << "seed " << seed;
    EXPECT_TRUE(findKinks(slopes(1, 39, random)).empty()) << "seed " << seed;
  }
}

TEST(FindKinks, IsNotWhereStripsDoNotFit)
{
  // One strip ends, and the next one lies .1 m lower: neighborhoods of 4 m across that
  // dip, and the slope is behind by as much as the bend makes up for in some meters.
  for (const std::uint32_t seed : {1, 2, 3}) {
    test::SceneBuilder random(seed);
    std::vector<Tangents::Sample> samples;
    for (double s = -60; s < 60; s += 0.5) {
      const double dip = std::abs(s) < 4 ? 0.03 * (1 - std::abs(s) / 4) : 0;
      samples.push_back({s, s / a - dip + random.normal(0.003)});
    }
    EXPECT_TRUE(findKinks(samples).empty()) << "seed " << seed;
  }
  EXPECT_TRUE(findKinks(std::vector<Tangents::Sample>{}).empty());
}

bench::SceneScores
scoresOf(bench::SceneKind kind, std::uint32_t seed)
{
  bench::SceneSettings settings;
  settings.kind = kind;
  settings.seed = seed;
  const bench::SceneScan scan = simulateScene(settings);
  CurveNetwork found;
  for (const Wire& wire : extractPowerLines(scan.points).wires) {
    Curve curve;
    curve.points = polyline(wire);
    found.curves.push_back(std::move(curve));
  }
  return scoreSceneWires(found, scan);
}

// Four wires .35 m apart with a point a meter: .815 before directions told of the
// poles.
TEST(Rack, IsFollowedFromPoleToPole)
{
  EXPECT_GT(scoresOf(bench::SceneKind::Town, 7).recall(), 0.86);
}

// 276 m of rows on roofs at the border of the data beside a line, which vouched for
// them.
TEST(Roofs, BesideALineAreNoWires)
{
  EXPECT_LT(scoresOf(bench::SceneKind::Town, 8).falseLength(), 15);
}

// Five parallel pipes that the border of the data cuts off, 118 m in all.
TEST(Pipes, AtTheBorderAreNoWires)
{
  EXPECT_LT(scoresOf(bench::SceneKind::ClutterEmpty, 6).falseLength(), 15);
}

} // namespace
} // namespace linelet::powerline
