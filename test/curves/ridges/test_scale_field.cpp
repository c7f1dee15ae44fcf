// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_int_distribution.hpp>
#include <gtest/gtest.h>

#include "curves/ridges/scale_field.h"

using namespace linelet;

namespace {

constexpr double wide = 0.5, narrow = 0.1;

/** \brief A line along x: spacing \ref wide below 0, \ref narrow above. */
Points
unevenLine()
{
  Points points;
  for (int i = -50; i < 0; ++i)
    points.emplace_back(wide * i, 0, 0);
  for (int i = 0; i < 50; ++i)
    points.emplace_back(narrow * i, 0, 0);
  return points;
}

} // namespace

TEST(ScaleField, IsTheDistanceOfTheSixthNeighborAlongALine)
{
  // Three points on either side.
  const double unit = 0.7;
  const ScaleField scales(unevenLine(), unit);
  EXPECT_NEAR(scales.at({-12.3, 0, 0}), 3 * wide / unit, 1e-12);
  EXPECT_NEAR(scales.at({2.5, 0, 0}), 3 * narrow / unit, 1e-12);
  EXPECT_NEAR(scales.spread(), wide / narrow, 1e-12);
}

TEST(ScaleField, DoesNotDependOnTheOrderOfThePoints)
{
  const Points points = unevenLine();
  Points shuffled = points;
  boost::random::mt19937 random(1);
  for (std::size_t i = shuffled.size(); i > 1; --i) {
    boost::random::uniform_int_distribution<std::size_t> before(0, i - 1);
    std::swap(shuffled[i - 1], shuffled[before(random)]);
  }
  const ScaleField scales(points, 1), other(shuffled, 1);
  for (const Point& p : points)
    EXPECT_NEAR(scales.at(p), other.at(p), 1e-12) << p.x();
}
