// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// Evenly curved curves in noise, and the prior on their bends.

#include <algorithm>
#include <cmath>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <gtest/gtest.h>

#include <linelet/curves/refined_reconstruction.h>

#include "curves/mixture/fit_of_start.h"
#include "curves/mixture/model_score.h"

using namespace linelet;

namespace {

/** \brief Points along the closed curve \a outline, with normal noise in its plane. */
Points
noisyRing(const Points& outline, std::size_t step, double noise, unsigned seed)
{
  boost::random::mt19937 random(seed);
  boost::random::normal_distribution<double> normal(0, noise);
  Points points;
  for (std::size_t i = 0; i < outline.size(); i += step) {
    const double x = normal(random);
    points.push_back(outline[i] + Point(x, normal(random), 0));
  }
  return points;
}

Points
circle()
{
  Points points;
  for (int i = 0; i < 720; ++i)
    points.emplace_back(std::cos(i * M_PI / 360), std::sin(i * M_PI / 360), 0);
  return points;
}

Points
square()
{
  Points points;
  for (int side = 0; side < 4; ++side)
    for (int i = 0; i < 180; ++i) {
      const double x = std::cos(side * M_PI / 2), y = std::sin(side * M_PI / 2);
      const double along = i / 90.0 - 1;
      points.emplace_back(x - along * y, y + along * x, 0);
    }
  return points;
}

EmFit
fitRing(const Points& points, const Points& start, bool even_curvature)
{
  ModelCurve curve;
  curve.nodes = start;
  curve.closed = true;
  EmSettings settings;
  settings.even_curvature = even_curvature;
  return fitOf(points, curve, 0.1, settings);
}

/** \brief Root mean square distance of the nodes of the only curve from the unit
 * circle. */
double
circleError(const ModelCurves& curves)
{
  EXPECT_EQ(curves.size(), 1u);
  double sum = 0;
  for (const Point& node : curves.at(0).nodes)
    sum += std::pow(node.norm() - 1, 2);
  return std::sqrt(sum / static_cast<double>(curves[0].nodes.size()));
}

// With the even-curvature prior an arc takes fewer parameters, follows the noise less,
// and is preferred by the criterion.
TEST(EvenBends, NoisyCirclesAreRounder)
{
  double plain = 0, even_curvature = 0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    const Points points = noisyRing(circle(), 6, 0.12, seed);
    const EmFit without = fitRing(points, circle(), false);
    const EmFit with = fitRing(points, circle(), true);
    plain += circleError(without.curves);
    even_curvature += circleError(with.curves);
    EXPECT_LT(with.freedom, without.freedom - 1);
    EXPECT_LT(scoreOf(with, points.size()), scoreOf(without, points.size()));
  }
  EXPECT_LT(even_curvature, 0.85 * plain);
}

// The sides of a square are straight; its corners must not affect how they bend.
TEST(EvenBends, SidesOfSquaresStayStraight)
{
  for (unsigned seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE(seed);
    const Points points = noisyRing(square(), 2, 0.02, seed);
    double error[2];
    for (const bool even_curvature : {false, true}) {
      double sum = 0;
      const EmFit fit = fitRing(points, square(), even_curvature);
      ASSERT_EQ(fit.curves.size(), 1u);
      for (const Point& node : fit.curves[0].nodes)
        sum += std::pow(std::max(std::abs(node.x()), std::abs(node.y())) - 1, 2);
      error[even_curvature] =
          std::sqrt(sum / static_cast<double>(fit.curves[0].nodes.size()));
    }
    EXPECT_LT(error[1], 1.1 * error[0]);
  }
}

// The whole method benefits: without the prior, nodes are .040 off on average.
TEST(EvenBends, CirclesInNoiseAreReconstructedRound)
{
  double sum = 0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    const CurveNetwork network =
        reconstructRefined(noisyRing(circle(), 6, 0.12, seed), {});
    ASSERT_EQ(network.curves.size(), 1u);
    ModelCurve curve;
    curve.nodes = network.curves[0].points;
    EXPECT_TRUE(network.curves[0].closed);
    sum += circleError({curve});
  }
  EXPECT_LT(sum / 20, 0.037);
}

} // namespace
