// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// The vectorized search gives exactly the points that plain arithmetic finds in a ball,
// bit for bit, and in a cylinder within it, whatever the length of a run.

#include <cstddef>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "curves/tracking/ball_points.h"

using namespace linelet;

TEST(BallPoints, AreThoseOfPlainArithmetic)
{
  const unsigned seed = 5;
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(-3, 3);
  Points points(200);
  for (Point& p : points)
    p = Point(place(random), place(random), place(random));
  const Point middle(-0.5, 0.1, 0.2);
  const double radius = 2;
  std::size_t all = 0;
  BallPoints found; // from all runs: points are appended
  for (std::size_t begin = 0; begin < 20; ++begin)
    for (const std::size_t end :
         {begin, begin + 1, begin + 7, begin + 33, points.size()}) {
      appendPointsInBall(middle, radius, points, begin, end, found);
      for (std::size_t i = begin; i < end; ++i) {
        const double squared = (points[i] - middle).squaredNorm();
        if (squared > radius * radius)
          continue;
        ASSERT_LT(all, found.count);
        EXPECT_EQ(found.index[all], i);
        EXPECT_EQ(found.squared[all], squared);
        for (int axis = 0; axis < 3; ++axis)
          EXPECT_EQ(found.offset[static_cast<std::size_t>(axis)][all],
                    points[i][axis] - middle[axis]);
        ++all;
      }
      EXPECT_EQ(found.count, all);
    }
  EXPECT_GT(all, 100U);
}

TEST(BallPoints, InACylinderAreCounted)
{
  const unsigned seed = 6;
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(-1, 1);
  const Point direction = Point(1, -2, 0.5).normalized();
  const double half = 0.8, radius = 0.3;
  std::size_t all = 0;
  for (std::size_t count = 0; count < 80; ++count) {
    Points points(count);
    for (Point& p : points)
      p = Point(place(random), place(random), place(random));
    BallPoints ball;
    if (count > 0)
      appendPointsInBall(Point::Zero(), 2, points, 0, count, ball);
    std::size_t inside = 0;
    for (const Point& p : points)
      inside += p.norm() <= half && (p - direction.dot(p) * direction).norm() <= radius;
    EXPECT_EQ(countInCylinder(ball, direction, half * half, radius * radius), inside);
    all += inside;
  }
  EXPECT_GT(all, 100U);
}
