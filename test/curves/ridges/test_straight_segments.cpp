// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <boost/random/uniform_real_distribution.hpp>
#include <gtest/gtest.h>

#include <linelet/curves/refined_reconstruction.h>

#include "curves/ridges/straight_segments.h"

using namespace linelet;

namespace {

constexpr double noise = 0.2;

/** \brief Noisy points of segments, and points anywhere in the box [-10, 10]^3. */
class Scatter {
public:
  explicit Scatter(double deviation = noise) : normal_(0, deviation) {}

  void
  addSegment(const Point& from, const Point& to, int count)
  {
    for (int i = 0; i < count; ++i) {
      const double t = uniform_(random_);
      Point p = from + t * (to - from);
      for (int axis = 0; axis < 3; ++axis)
        p[axis] += normal_(random_);
      points.push_back(p);
    }
  }
  void
  addAnywhere(int count)
  {
    for (int i = 0; i < count; ++i) {
      Point p;
      for (int axis = 0; axis < 3; ++axis)
        p[axis] = 20 * uniform_(random_) - 10;
      points.push_back(p);
    }
  }

  Points points;

private:
  boost::random::mt19937 random_{5};
  boost::random::normal_distribution<double> normal_;
  boost::random::uniform_real_distribution<double> uniform_{0, 1};
};

SegmentSettings
settingsOf(double density, double background)
{
  SegmentSettings settings;
  settings.noise = noise;
  settings.density = density;
  settings.background = background / 8000;
  settings.least_length = 1;
  return settings;
}

/** \brief How far the ends of the nearest of \a curves lie from those of a segment. */
double
distanceTo(const ModelCurves& curves, const Point& from, const Point& to)
{
  double best = 1e300;
  for (const ModelCurve& curve : curves) {
    const Point &a = curve.nodes.front(), &b = curve.nodes.back();
    best = std::min(best, std::max((a - from).norm(), (b - to).norm()));
    best = std::min(best, std::max((b - from).norm(), (a - to).norm()));
  }
  return best;
}

/** \brief Expects \a found to be the two segments from a to b and from c to d. */
void
expectBoth(const ModelCurves& found,
           const Point& a,
           const Point& b,
           const Point& c,
           const Point& d)
{
  EXPECT_EQ(found.size(), 2u);
  EXPECT_LT(distanceTo(found, a, b), 1);
  EXPECT_LT(distanceTo(found, c, d), 1);
}

} // namespace

TEST(StraightSegments, CrossAtASmallAngle)
{
  Scatter scatter;
  const Point a(-8, -1, 0), b(8, 1, 0), c(-8, 1.5, 0.2), d(8, -1.5, 0.2);
  scatter.addSegment(a, b, 100);
  scatter.addSegment(c, d, 100);
  scatter.addAnywhere(60);
  expectBoth(straightSegments(scatter.points, settingsOf(6, 60)), a, b, c, d);
}

TEST(StraightSegments, AreSeparateOnBothSidesOfAGap)
{
  Scatter scatter;
  const Point a(-9, 0, 0), b(-2, 0, 0), c(3, 0, 0), d(9, 0, 0);
  scatter.addSegment(a, b, 60);
  scatter.addSegment(c, d, 50);
  scatter.addAnywhere(40);
  expectBoth(straightSegments(scatter.points, settingsOf(8, 40)), a, b, c, d);
}

TEST(StraightSegments, BranchesEndWhereTheyLeave)
{
  Scatter scatter;
  const Point a(-8, 0, 0), b(8, 0, 0), c(1, 0, 0), d(5, 5, 2);
  scatter.addSegment(a, b, 120);
  scatter.addSegment(c, d, 50);
  expectBoth(straightSegments(scatter.points, settingsOf(7.5, 5)), a, b, c, d);
}

TEST(StraightSegments, AreNotFoundAmongScatteredPoints)
{
  Scatter scatter;
  scatter.addAnywhere(300);
  EXPECT_TRUE(straightSegments(scatter.points, settingsOf(6, 300)).empty());
  for (const Points& few : {Points(), Points(1, {1, 1, 1}), Points(50, {1, 1, 1})})
    EXPECT_TRUE(straightSegments(few, settingsOf(6, 300)).empty()) << few.size();
}

// Four lines that cross each other, whose points scatter by a twentieth of their
// length: without segments, ridges lead around the corners.
TEST(StraightSegments, MakeUpNoisyNetworks)
{
  Scatter scatter(0.4);
  scatter.addSegment({-5, -3, 0}, {5, -1, 1}, 60);
  scatter.addSegment({-5, 3, 1}, {5, -3, 0}, 60);
  scatter.addSegment({-3, -5, 0}, {-1, 5, 1}, 60);
  scatter.addSegment({4, -5, 1}, {0, 5, 0}, 60);
  const CurveNetwork found = reconstructRefined(scatter.points, {});
  ASSERT_EQ(found.curves.size(), 4u);
  ModelCurves curves(4);
  for (std::size_t c = 0; c < 4; ++c)
    curves[c].nodes = found.curves[c].points;
  EXPECT_LT(distanceTo(curves, {-5, -3, 0}, {5, -1, 1}), 1);
  EXPECT_LT(distanceTo(curves, {-5, 3, 1}, {5, -3, 0}), 1);
  EXPECT_LT(distanceTo(curves, {-3, -5, 0}, {-1, 5, 1}), 1);
  EXPECT_LT(distanceTo(curves, {4, -5, 1}, {0, 5, 0}), 1);
}
