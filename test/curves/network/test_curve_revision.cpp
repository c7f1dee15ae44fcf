// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// How the model search revises its curves: reconnecting, doubling, fixed-radius noise.

#include <algorithm>
#include <cmath>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <boost/random/uniform_real_distribution.hpp>
#include <gtest/gtest.h>

#include <linelet/search/scale_unit.h>

#include "curves/mixture/em_fit.h"
#include "curves/mixture/model_score.h"
#include "curves/network/doubling.h"
#include "curves/network/revision.h"

using namespace linelet;

namespace {

ModelCurve
polyline(const Points& corners, double spacing)
{
  ModelCurve curve;
  curve.nodes = corners;
  return resampled(curve, spacing);
}

/** \brief Largest angle between the first edge and any other, in degrees. */
double
turn(const ModelCurve& curve)
{
  const Point first = (curve.to(0) - curve.from(0)).normalized();
  double least = 1;
  for (std::size_t e = 0; e < curve.edges(); ++e)
    least = std::min(least, first.dot((curve.to(e) - curve.from(e)).normalized()));
  return std::acos(least) * 180 / M_PI;
}

TEST(CurveRevision, CrossingLinesThatSwappedTheirHalvesAreStraightAgain)
{
  const ModelCurves swapped = {
      polyline({{-5, 0, 0.1}, {0, 0, 0.1}, {0, 5, 0.1}}, 0.25),
      polyline({{5, 0, -0.1}, {0.1, 0, -0.1}, {0.1, -5, -0.1}}, 0.25)};
  for (const Rejoining rejoining : {Rejoining::Paired, Rejoining::Bridged}) {
    const ModelCurves result =
        rejoined(swapped, doubtfulPlaces(swapped, 0.6), 0.6, rejoining);
    ASSERT_EQ(result.size(), 2u);
    for (const ModelCurve& curve : result) {
      EXPECT_NEAR(length(curve), 10, 0.2);
      EXPECT_LT(turn(curve), 25);
    }
  }
}

TEST(CurveRevision, AtOnePlaceTheOthersStayAsTheyAre)
{
  // Two crossings, far apart; at each, two lines have swapped their halves.
  ModelCurves swapped;
  for (const double x : {0.0, 20.0}) {
    swapped.push_back(polyline({{x - 5, 0, 0.1}, {x, 0, 0.1}, {x, 5, 0.1}}, 0.25));
    swapped.push_back(
        polyline({{x + 5, 0, -0.1}, {x + 0.1, 0, -0.1}, {x + 0.1, -5, -0.1}}, 0.25));
  }
  const Points places = {Point(0, 0, 0)};
  for (const Rejoining rejoining : {Rejoining::Paired, Rejoining::Bridged}) {
    const ModelCurves result = rejoined(swapped, places, 0.6, rejoining);
    ASSERT_EQ(result.size(), 4u);
    int straight = 0;
    for (const ModelCurve& curve : result) {
      const bool near = curve.nodes.front().x() < 10;
      EXPECT_EQ(turn(curve) < 25, near);
      straight += turn(curve) < 25 ? 1 : 0;
    }
    EXPECT_EQ(straight, 2);
  }
}

TEST(CurveRevision, CurvesApartAndSmoothAreNotInDoubt)
{
  const ModelCurves apart = {polyline({{-5, 0, 0}, {5, 0, 0}}, 0.25),
                             polyline({{-5, 2, 0}, {5, 3, 0}}, 0.25)};
  EXPECT_TRUE(doubtfulPlaces(apart, 0.6).empty());
  EXPECT_TRUE(doubtfulPlaces({}, 0.6).empty());
  for (const Rejoining rejoining : {Rejoining::Paired, Rejoining::Bridged})
    EXPECT_TRUE(rejoined(apart, {}, 0.6, rejoining).empty());
}

/** \brief Points 0.05 apart on an arc of \a radius over 4 radians. */
void
addArc(Points& points, double radius, boost::random::mt19937& random)
{
  boost::random::normal_distribution<double> normal(0, 0.1);
  for (double angle = 0; angle < 4; angle += 0.05 / radius) {
    Point p(radius * std::cos(angle), radius * std::sin(angle), 0);
    for (int axis = 0; axis < 3; ++axis)
      p[axis] += normal(random);
    points.push_back(p);
  }
}

TEST(CurveRevision, CurveBetweenTwoArcsIsDoubled)
{
  boost::random::mt19937 random(4);
  ModelCurve middle;
  for (double angle = 0; angle < 4; angle += 0.05)
    middle.nodes.emplace_back(5 * std::cos(angle), 5 * std::sin(angle), 0);
  Points points;
  addArc(points, 4.5, random);
  addArc(points, 5.5, random);
  const ModelCurves two = doubled({middle}, points, UniformGrid(points, 1), 2, 2);
  ASSERT_EQ(two.size(), 2u);
  for (const ModelCurve& curve : two) {
    const double radius = curve.nodes.front().norm();
    EXPECT_NEAR(std::abs(radius - 5), 0.5, 0.1);
    for (const Point& node : curve.nodes)
      EXPECT_NEAR(node.norm(), radius, 0.1);
  }
  Points one;
  addArc(one, 5, random);
  EXPECT_TRUE(doubled({middle}, one, UniformGrid(one, 1), 2, 2).empty());
}

/** \brief A straight line of length 20 whose points are moved by \a displace. */
template <class Displace>
Points
line(Displace&& displace)
{
  Points points;
  for (int i = 0; i < 500; ++i)
    points.push_back(Point(0.04 * i, 0, 0) + displace());
  return points;
}

EmFit
fitLine(const Points& points, double noise, double fixed_radius)
{
  const double unit = scaleUnit(points, 0, 1, 1);
  const UniformGrid grid(points, 2 * unit);
  const CloudFrame frame = frameOf(points, unit);
  EmSettings settings;
  settings.spacing = 0.4 * unit;
  settings.noise = noise;
  settings.least_noise = 0.1 * unit;
  settings.bending = 1 / frame.diagonal;
  settings.fixed_radius = fixed_radius;
  return EmFitter(points, grid, frame)
      .fit({polyline({{0, 0.1, 0}, {20, -0.1, 0}}, unit)}, settings);
}

double
meanOffset(const EmFit& fit)
{
  double sum = 0, count = 0;
  for (const ModelCurve& curve : fit.curves)
    for (const Point& node : curve.nodes) {
      sum += std::hypot(node.y(), node.z());
      count += 1;
    }
  return sum / count;
}

TEST(FixedRadiusNoise, IsDistinguishedFromNormalNoiseAndGivesTheBetterCurve)
{
  boost::random::mt19937 random(9);
  boost::random::normal_distribution<double> normal;
  const auto vector = [&] { // one draw per statement, since the order matters
    const double x = normal(random);
    const double y = normal(random);
    const double z = normal(random);
    return Point(x, y, z);
  };
  const Points fixed_radius = line([&] { return Point(0.8 * vector().normalized()); });
  const EmFit as_normal = fitLine(fixed_radius, 0.4, 0),
              as_fixed_radius = fitLine(fixed_radius, 0.16, 0.9);
  EXPECT_NEAR(as_normal.kurtosis, 1.2, 0.2);
  EXPECT_NEAR(as_fixed_radius.fixed_radius, 0.8, 0.04);
  EXPECT_LT(scoreOf(as_fixed_radius, fixed_radius.size()),
            scoreOf(as_normal, fixed_radius.size()) - 100);
  EXPECT_LT(meanOffset(as_fixed_radius), 0.6 * meanOffset(as_normal));

  const Points round = line([&] { return Point(0.4 * vector()); });
  const EmFit rightly = fitLine(round, 0.4, 0), wrongly = fitLine(round, 0.16, 0.7);
  EXPECT_NEAR(rightly.kurtosis, 2, 0.3);
  EXPECT_GT(scoreOf(wrongly, round.size()), scoreOf(rightly, round.size()));
}

} // namespace
