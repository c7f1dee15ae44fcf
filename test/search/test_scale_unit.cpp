// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_real_distribution.hpp>
#include <gtest/gtest.h>

#include <linelet/search/kd_tree.h>
#include <linelet/search/scale_unit.h>

using namespace linelet;

namespace {

Points
box(std::size_t count, unsigned seed)
{
  boost::random::mt19937 random(seed);
  boost::random::uniform_real_distribution<double> unit(0, 1);
  Points points;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = unit(random), y = unit(random);
    points.emplace_back(x, y, unit(random));
  }
  return points;
}

double
bruteForce(const Points& points)
{
  std::vector<double> sixth;
  for (const Point& query : points) {
    std::vector<double> distances;
    for (const Point& point : points)
      distances.push_back((point - query).norm());
    std::sort(distances.begin(), distances.end());
    sixth.push_back(distances[6]); // distances[0] is the point itself
  }
  std::sort(sixth.begin(), sixth.end());
  return sixth[(sixth.size() - 1) / 2];
}

} // namespace

TEST(ScaleUnit, IsTheMedianDistanceToTheSixthNeighbor)
{
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const Points points = box(400 + seed, seed);
    EXPECT_DOUBLE_EQ(scaleUnit(points, 0), bruteForce(points)) << "seed " << seed;
    EXPECT_DOUBLE_EQ(scaleUnit(points, 9999), bruteForce(points)) << "seed " << seed;
  }
}

TEST(ScaleUnit, OfEquallySpacedPointsOnALineIsThreeSteps)
{
  Points points;
  for (int i = 0; i < 1000; ++i)
    points.emplace_back(0.25 * i, 0, 0);
  EXPECT_DOUBLE_EQ(scaleUnit(points, 0), 0.75);
  EXPECT_DOUBLE_EQ(scaleUnit(points, 100), 0.75);
}

TEST(ScaleUnit, OfARandomSubsetIsCloseAndDependsOnTheSeedAlone)
{
  const Points points = box(5000, 1);
  const double all = scaleUnit(points, 0);
  EXPECT_NEAR(scaleUnit(points, 1024, 1), all, 0.05 * all);
  EXPECT_NEAR(scaleUnit(points, 1024, 2), all, 0.05 * all);
  EXPECT_EQ(scaleUnit(points, 1024, 7, 1), scaleUnit(points, 1024, 7, 4));
}

TEST(ScaleUnit, DoesNotMoveWithThePointsAndGrowsWithThem)
{
  const Points points = box(500, 1);
  Points moved;
  for (const Point& point : points)
    moved.push_back(8 * point + Point(1 << 19, 1 << 22, 0));
  EXPECT_NEAR(scaleUnit(moved), 8 * scaleUnit(points), 1e-8);
}

TEST(ScaleUnit, OfFewCoincidentOrNonFinitePoints)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isnan(scaleUnit({})));
  EXPECT_TRUE(std::isnan(scaleUnit({Point(1, 2, 3)})));
  EXPECT_TRUE(std::isnan(scaleUnit({Point(1, 2, 3), Point(nan, 0, 0)})));
  EXPECT_EQ(scaleUnit({Point(0, 0, 0), Point(3, 4, 0)}), 5);
  // The farthest others are 3, 2 and 3 away.
  EXPECT_EQ(scaleUnit({Point(0, 0, 0), Point(1, 0, 0), Point(3, 0, 0)}), 3);
  EXPECT_EQ(scaleUnit(Points(100, Point(5e5, 5e6, 1))), 0);
  Points points = box(300, 2);
  const double clean = scaleUnit(points, 0);
  points.resize(400, Point(nan, nan, nan));
  EXPECT_EQ(scaleUnit(points, 0), clean);
}

TEST(ScaleUnit, IsTheSameWithAnySearch)
{
  boost::random::mt19937 random(8);
  boost::random::uniform_real_distribution<double> unit(-1, 1);
  Points points;
  for (int i = 0; i < 3000; ++i) {
    const double x = unit(random), y = unit(random);
    points.emplace_back(x, y, i % 3 == 0 ? 0 : unit(random));
  }
  points[5].x() = std::numeric_limits<double>::quiet_NaN();
  for (const std::size_t sample : {0u, 1024u})
    EXPECT_EQ(scaleUnit(KdTree(points), points, sample), scaleUnit(points, sample));
  const Points one = {Point(1, 2, 3)};
  EXPECT_TRUE(std::isnan(scaleUnit(KdTree(one), one)));
}
