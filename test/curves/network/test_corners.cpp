// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// Sharp corners: vertices exempt from the bending prior.

#include <algorithm>
#include <cmath>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <boost/random/uniform_real_distribution.hpp>
#include <gtest/gtest.h>

#include <linelet/curves/reconstruct_curves.h>

#include "curves/network/corners.h"

using namespace linelet;

namespace {

/** \brief The end of an arm of a V whose apex is the origin; \a side -1 or 1. */
Point
arm(double angle, double reach, int side)
{
  return {-reach * std::cos(0.5 * angle), side * reach * std::sin(0.5 * angle), 0};
}

/** \brief Two arms of length 5 that meet at \a angle in the origin, rounded there by a
 * circle of \a radius that touches both. */
ModelCurve
rounded(double angle, double radius)
{
  const double half = 0.5 * angle;
  const double center = -radius / std::sin(half), cut = radius / std::tan(half);
  ModelCurve curve;
  curve.nodes.push_back(arm(angle, 5, -1));
  for (int k = 0; k <= 40; ++k) {
    const double t = (M_PI_2 - half) * (k / 20.0 - 1);
    curve.nodes.emplace_back(center + radius * std::cos(t), radius * std::sin(t), 0);
  }
  curve.nodes.push_back(arm(angle, 5, 1));
  EXPECT_NEAR((curve.nodes[1] - arm(angle, cut, -1)).norm(), 0, 1e-9);
  return curve;
}

TEST(Corners, ArmsOfARoundedBendMeetAtItsApex)
{
  for (const double degrees : {30, 60, 90, 120}) {
    const double angle = degrees * M_PI / 180;
    // The circle begins within the size of the bend.
    const ModelCurves sharp =
        sharpened({rounded(angle, 0.4 * std::tan(0.5 * angle))}, 0.6);
    ASSERT_EQ(sharp.size(), 1u) << degrees;
    ASSERT_EQ(sharp[0].hinges.size(), 1u) << degrees;
    EXPECT_LT(sharp[0].nodes[sharp[0].hinges[0]].norm(), 0.02) << degrees;
    EXPECT_NEAR(length(sharp[0]), 10, 0.05) << degrees;
  }
}

TEST(Corners, SmoothCurvesHaveNone)
{
  ModelCurve circle;
  circle.closed = true;
  for (int k = 0; k < 100; ++k)
    circle.nodes.emplace_back(
        5 * std::cos(0.02 * M_PI * k), 5 * std::sin(0.02 * M_PI * k), 0);
  EXPECT_TRUE(sharpened({circle}, 0.6).empty());
  ModelCurve line;
  line.nodes = {{0, 0, 0}, {10, 0, 0}};
  EXPECT_TRUE(sharpened({line}, 0.6).empty());
  line.nodes = {{0, 0, 0}, {0.1, 0, 0}}; // shorter than a bend
  EXPECT_TRUE(sharpened({line}, 0.6).empty());
  EXPECT_TRUE(sharpened({}, 0.6).empty());
}

TEST(Corners, SurviveResampling)
{
  ModelCurve square;
  square.nodes = {{0.5, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 0}};
  square.hinges = {1, 2, 3, 4};
  for (const bool closed : {true, false})
    for (const double spacing : {0.03, 0.11, 0.7}) {
      square.closed = closed;
      const ModelCurve fine = resampled(square, spacing);
      EXPECT_EQ(fine.closed, closed);
      ASSERT_EQ(fine.hinges.size(), 4u);
      for (const Point& corner : {Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0)})
        EXPECT_TRUE(
            std::any_of(fine.hinges.begin(), fine.hinges.end(), [&](std::size_t k) {
              return fine.nodes[k] == corner;
            }));
      EXPECT_NEAR(length(fine), length(square), 1e-12);
    }
}

TEST(Corners, AcuteCornersOfNoisyCloudsAreKept)
{
  // 400 points of a V with arms of length 6, noise of a twentieth of them.
  for (const double degrees : {35, 60}) {
    const double angle = degrees * M_PI / 180;
    for (unsigned seed = 1; seed <= 5; ++seed) {
      boost::random::mt19937 random(seed);
      boost::random::uniform_real_distribution<double> place(0, 6);
      boost::random::normal_distribution<double> noise(0, 0.3);
      Points points;
      for (int i = 0; i < 400; ++i) {
        const Point at = arm(angle, place(random), i % 2 == 0 ? -1 : 1);
        const double x = noise(random), y = noise(random), z = noise(random);
        points.emplace_back(at + Point(x, y, z));
      }
      const CurveNetwork found = reconstructCurves(points, {});
      double nearest = 1e300, total = 0;
      for (const Curve& curve : found.curves) {
        total += length(curve);
        for (const Point& p : curve.points)
          nearest = std::min(nearest, p.norm());
      }
      EXPECT_LT(nearest, 0.3) << degrees << " degrees, seed " << seed;
      EXPECT_NEAR(total, 12, 0.9) << degrees << " degrees, seed " << seed;
    }
  }
}

} // namespace
