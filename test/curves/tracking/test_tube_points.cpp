// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// The vectorized search gives exactly the points that plain arithmetic finds in a tube,
// bit for bit, whatever the length of a run.

#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "curves/tracking/tube_points.h"

using namespace linelet;

TEST(TubePoints, AreThoseOfPlainArithmetic)
{
  const unsigned seed = 5;
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(-3, 3);
  Points points(200);
  for (Point& p : points)
    p = Point(place(random), place(random), place(random));
  const Tube tube = {Point(-2, 0.1, 0),
                     Point(3, 1, -0.5).normalized(),
                     Point(0.02, -0.1, 0.08),
                     4,
                     1.5 * 1.5};
  std::size_t all = 0;
  for (std::size_t begin = 0; begin < 20; ++begin)
    for (const std::size_t end :
         {begin, begin + 1, begin + 7, begin + 33, points.size()}) {
      TubePoints found;
      appendPointsInTube(tube, points, begin, end, found);
      std::size_t n = 0;
      for (std::size_t i = begin; i < end; ++i) {
        const Point v = points[i] - tube.at;
        const double along = tube.direction.dot(v);
        const Point off = v - along * (tube.direction + 0.5 * along * tube.curvature);
        if (!(along > 0 && along <= tube.length) ||
            off.squaredNorm() > tube.squared_radius)
          continue;
        ASSERT_LT(n, found.count);
        EXPECT_EQ(found.index[n], i);
        EXPECT_EQ(found.place[n], along);
        EXPECT_EQ(found.squared[n], off.squaredNorm());
        ++n;
      }
      EXPECT_EQ(found.count, n);
      all += n;
    }
  EXPECT_GT(all, 100U);
}

TEST(TubePoints, AreAppendedAndNeverNaN)
{
  const double nan = std::nan("");
  const Points points = {Point(1, 0, 0), Point(nan, 0, 0), Point(2, 0, 0)};
  const Tube tube = {Point::Zero(), Point::UnitX(), Point::Zero(), 10, 1};
  TubePoints found;
  appendPointsInTube(tube, points, 2, 3, found);
  appendPointsInTube(tube, points, 0, 3, found);
  ASSERT_EQ(found.count, 3U);
  EXPECT_EQ(found.index[0], 2U);
  EXPECT_EQ(found.index[1], 0U);
  EXPECT_EQ(found.index[2], 2U);
}
