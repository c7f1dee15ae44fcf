// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "model/picking.h"
#include "random_seed.h"

namespace {

using namespace linelet;
using namespace linelet::view;

/** What pick() promises, by looking at every point. */
Index
pickByHand(const Points& points, const Ray& ray, double depth)
{
  struct Seen {
    double at, beside;
    Index index;
  };
  std::vector<Seen> seen;
  double deepest = depth;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point offset = points[i] - ray.origin;
    const double at = offset.dot(ray.direction);
    const double beside = (offset - at * ray.direction).norm();
    if (!(at >= 0 && at <= depth && beside <= ray.radius + ray.spread * at))
      continue;
    seen.push_back({at, beside, static_cast<Index>(i)});
    deepest = std::min(deepest, at + 2 * (ray.radius + ray.spread * at));
  }
  Index best = UniformGrid::none;
  double least = std::numeric_limits<double>::infinity();
  for (const Seen& one : seen)
    if (one.at <= deepest && one.beside < least) {
      least = one.beside;
      best = one.index;
    }
  return best;
}

TEST(Picking, FindsWhatALookAtEveryPointFinds)
{
  std::mt19937 random(test::randomSeed());
  std::uniform_real_distribution<double> place(-10, 10);
  Points points;
  for (int i = 0; i < 3000; ++i)
    points.emplace_back(place(random), place(random), 0.1 * place(random));
  points.emplace_back(std::numeric_limits<double>::quiet_NaN(), 0, 0);
  const UniformGrid grid(points, 0.7);
  int hits = 0;
  for (int i = 0; i < 300; ++i) {
    Ray ray;
    ray.origin = Point(place(random), place(random), 30);
    ray.direction = (Point(place(random), place(random), 0) - ray.origin).normalized();
    ray.radius = i % 3 == 0 ? 0 : 0.05;
    ray.spread = i % 2 == 0 ? 0.004 : 0.02;
    const Index found = pick(grid, ray, 80);
    EXPECT_EQ(found, pickByHand(points, ray, 80)) << i;
    hits += found != UniformGrid::none ? 1 : 0;
  }
  EXPECT_GT(hits, 50);
}

// A wire in front of a roof: the click selects the wire.
TEST(Picking, TheForemostIsMeant)
{
  const Points points = {{0.1, 0, 0}, {0, 0, -5}, {0.02, 0, -9}};
  const UniformGrid grid(points, 1);
  const Ray ray = {Point(0, 0, 20), Point(0, 0, -1), 0.2, 0};
  EXPECT_EQ(pick(grid, ray, 40), 0u);
  // A click beside everything.
  EXPECT_EQ(pick(grid, {Point(3, 0, 20), Point(0, 0, -1), 0.2, 0}, 40),
            UniformGrid::none);
}

TEST(Picking, OnePointAndNone)
{
  const Ray ray = {Point(0, 0, 20), Point(0, 0, -1), 0, 0.01};
  EXPECT_EQ(pick(UniformGrid({Point(0, 0, 0)}, 1), ray, 40), 0u);
  EXPECT_EQ(pick(UniformGrid({}, 1), ray, 40), UniformGrid::none);
}

TEST(RandomSubset, HasNoPointTwiceAndIsTheSameAgain)
{
  const Indices chosen = randomSubset(10000, 1000);
  ASSERT_EQ(chosen.size(), 1000u);
  EXPECT_TRUE(std::adjacent_find(chosen.begin(), chosen.end(), [](Index a, Index b) {
                return a >= b;
              }) == chosen.end());
  EXPECT_EQ(chosen, randomSubset(10000, 1000));
  EXPECT_EQ(randomSubset(3, 1000), (Indices{0, 1, 2}));
  EXPECT_TRUE(randomSubset(0, 1000).empty());
}

} // namespace
