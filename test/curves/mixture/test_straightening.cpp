// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// Straight curves in noise, and what they cost.

#include <cmath>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <gtest/gtest.h>

#include "curves/mixture/fit_of_start.h"
#include "curves/mixture/model_score.h"

using namespace linelet;

namespace {

constexpr double noise = 0.1;

/** \brief Points along \a curve, with normal noise. */
Points
noisy(const Points& curve, unsigned seed)
{
  boost::random::mt19937 random(seed);
  boost::random::normal_distribution<double> normal(0, noise);
  Points points;
  for (const Point& p : curve) {
    const double x = normal(random), y = normal(random);
    points.push_back(p + Point(x, y, normal(random)));
  }
  return points;
}

/** \brief An arc of length 10 that turns by \a turn, or a line; it begins at the
 * origin along x. */
Points
arc(double turn)
{
  Points points;
  for (int i = 0; i < 200; ++i) {
    const double length = i * 0.05, angle = turn * length / 10;
    points.push_back(
        turn > 0
            ? Point(10 / turn * std::sin(angle), 10 / turn * (1 - std::cos(angle)), 0)
            : Point(length, 0, 0));
  }
  return points;
}

EmFit
fitArc(const Points& truth, unsigned seed, bool straight)
{
  ModelCurve curve;
  curve.nodes = truth;
  EmSettings settings;
  settings.straight = straight;
  return fitOf(noisy(truth, seed), curve, 0.1, settings);
}

// In space a line has two parameters per coordinate across it.
TEST(Straightening, LinesHaveFourParameters)
{
  for (unsigned seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    const Points truth = arc(0);
    const EmFit bent = fitArc(truth, seed, false), fit = fitArc(truth, seed, true);
    ASSERT_EQ(fit.curves.size(), 1u);
    EXPECT_NEAR(fit.freedom, 4, 0.1);
    EXPECT_LT(scoreOf(fit, truth.size()), scoreOf(bent, truth.size()));
    // The standard error of the ends of a regression line is 2 / sqrt(n) of the noise.
    for (const Point& node : fit.curves[0].nodes)
      EXPECT_LT(std::hypot(node.y(), node.z()),
                4 * noise * 2 / std::sqrt(static_cast<double>(truth.size())));
  }
}

TEST(Straightening, ArcsStayBent)
{
  for (unsigned seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    const Points truth = arc(0.5);
    EXPECT_EQ(fitArc(truth, seed, true).freedom, fitArc(truth, seed, false).freedom);
  }
}

} // namespace
