// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// Wires hidden in clutter, found from a clear one beside or before them.
#include <random>

#include <gtest/gtest.h>

#include "curves/tracking/parallel_seeds.h"

using namespace linelet;

namespace {

constexpr double beyond = 150; // spacings

/** \brief A straight curve from x = 0 to 40, of 2 points per unit. */
ModelCurve
clearCurve()
{
  ModelCurve curve;
  curve.nodes = {{0, 0, 0}, {20, 0, 0}, {40, 0, 0}};
  curve.counts = {40, 40};
  curve.noise = 0.05;
  return curve;
}

/** \brief One point per cubic unit, from x = 0 to 100, and a line of .8 points per unit
 * parallel to the curve. */
Points
lineInClutter(double y, double z, double from, double to, unsigned seed)
{
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0, 0.05);
  std::uniform_real_distribution<double> along(0, 100), across(-5, 5),
      on_line(from, to);
  Points points;
  for (int k = 0; k < 10000; ++k)
    points.emplace_back(along(random), across(random), across(random));
  for (int k = 0; k < static_cast<int>(0.8 * (to - from)); ++k)
    points.emplace_back(on_line(random), y + noise(random), z + noise(random));
  return points;
}

std::vector<TrackSeed>
seedsIn(const Points& points, unsigned threads = 1)
{
  const TrackedScene scene(points, 0.6);
  return seedsAlongCurves(scene, {clearCurve()}, beyond, threads);
}

TEST(ParallelSeeds, ALineBesideTheCurveIsTheBest)
{
  for (const unsigned seed : {1U, 2U, 3U}) {
    SCOPED_TRACE(seed);
    const auto seeds = seedsIn(lineInClutter(2, -1, 0, 40, seed));
    ASSERT_FALSE(seeds.empty());
    EXPECT_NEAR(seeds.front().at.y(), 2, 0.1);
    EXPECT_NEAR(seeds.front().at.z(), -1, 0.1);
    EXPECT_GT(std::abs(seeds.front().direction.x()), 0.999);
    EXPECT_NEAR(seeds.front().density, 0.9, 0.5);
  }
}

TEST(ParallelSeeds, SoIsOneBeyondItsEnd)
{
  for (const unsigned seed : {1U, 2U, 3U}) {
    SCOPED_TRACE(seed);
    const auto seeds = seedsIn(lineInClutter(1, 1, 60, 100, seed));
    ASSERT_FALSE(seeds.empty());
    EXPECT_NEAR(seeds.front().at.y(), 1, 0.1);
    EXPECT_NEAR(seeds.front().at.z(), 1, 0.1);
    EXPECT_GT(seeds.front().at.x(), 55);
  }
}

TEST(ParallelSeeds, ClutterAloneGivesHardlyAny)
{
  std::size_t seeds = 0;
  for (unsigned seed = 1; seed <= 10; ++seed)
    seeds += seedsIn(lineInClutter(0, 0, 0, 0, seed)).size();
  EXPECT_LE(seeds, 3U);
}

TEST(ParallelSeeds, DegenerateInputGivesNone)
{
  const TrackedScene empty({}, 1), one({{1, 1, 1}}, 1);
  const TrackedScene coincident(Points(50, {1, 1, 1}), 1);
  ModelCurve point;
  point.nodes = {{1, 1, 1}, {1, 1, 1}};
  point.counts = {50};
  for (const TrackedScene* scene : {&empty, &one, &coincident}) {
    EXPECT_TRUE(seedsAlongCurves(*scene, {}, beyond, 1).empty());
    EXPECT_TRUE(seedsAlongCurves(*scene, {point}, beyond, 1).empty());
  }
}

TEST(ParallelSeeds, DoNotDependOnThreads)
{
  const Points points = lineInClutter(2, -1, 0, 100, 4);
  const TrackedScene scene(points, 0.6);
  ModelCurves curves(3, clearCurve());
  for (Point& node : curves[1].nodes)
    node.y() += 1;
  for (Point& node : curves[2].nodes)
    node.x() += 30;
  const auto one = seedsAlongCurves(scene, curves, beyond, 1);
  const auto four = seedsAlongCurves(scene, curves, beyond, 4);
  ASSERT_EQ(one.size(), four.size());
  for (std::size_t k = 0; k < one.size(); ++k) {
    EXPECT_EQ(one[k].index, four[k].index);
    EXPECT_EQ(one[k].at, four[k].at);
    EXPECT_EQ(one[k].quality, four[k].quality);
  }
}

} // namespace
