// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// Noise whose width varies along the curve, compared with the true widths.

#include <algorithm>
#include <cmath>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <boost/random/uniform_real_distribution.hpp>
#include <gtest/gtest.h>

#include <linelet/curves/refined_reconstruction.h>

#include "curves/mixture/fit_of_start.h"
#include "curves/mixture/model_score.h"

using namespace linelet;

namespace {

constexpr double line_length = 10;

/** \brief Points along the x axis from 0 to 10, whose noise grows by a factor of
 * \a growth from 0.03. */
Points
noisyLine(double growth, unsigned seed)
{
  boost::random::mt19937 random(seed);
  boost::random::uniform_real_distribution<double> along(0, line_length);
  boost::random::normal_distribution<double> normal;
  Points points;
  for (int i = 0; i < 400; ++i) {
    const double x = along(random);
    const double noise = 0.03 * std::pow(growth, x / line_length);
    const double y = noise * normal(random);
    points.emplace_back(x, y, noise * normal(random));
  }
  return points;
}

EmFit
fitLine(const Points& points, bool varied_noise)
{
  ModelCurve start;
  start.nodes = {{0, 0, 0}, {line_length, 0, 0}};
  EmSettings settings;
  settings.varied_noise = varied_noise;
  return fitOf(points, start, 0.01, settings);
}

TEST(VariedNoise, WidthsFollowNoiseThatGrowsTenfold)
{
  for (unsigned seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE(seed);
    const EmFit fit = fitLine(noisyLine(10, seed), true);
    ASSERT_EQ(fit.curves.size(), 1u);
    const Points& nodes = fit.curves[0].nodes;
    ASSERT_EQ(fit.noises.size(), 1u);
    ASSERT_EQ(fit.noises[0].size(), nodes.size());
    double sum = 0, worst = 0, chi_squared = 0;
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      const double x = std::clamp(nodes[k].x(), 0.0, line_length);
      const double noise = 0.03 * std::pow(10, x / line_length);
      const double off = std::log(fit.noises[0][k] / noise);
      sum += off;
      worst = std::max(worst, std::abs(off));
      chi_squared += std::pow(std::hypot(nodes[k].y(), nodes[k].z()) / noise, 2);
    }
    EXPECT_LT(std::abs(sum) / static_cast<double>(nodes.size()), std::log(1.15));
    EXPECT_LT(worst, std::log(1.8));
    // The errors of a linear fit, squared in units of the noise and summed over the
    // points, are on average at most its degrees of freedom (its trace); the standard
    // deviation of the sum is at most sqrt(2 freedom).
    const double per_node = 400 / static_cast<double>(nodes.size());
    EXPECT_LT(chi_squared * per_node, fit.freedom + 4 * std::sqrt(2 * fit.freedom));
  }
}

TEST(VariedNoise, TheCriterionTellsWhetherItVaries)
{
  int growing = 0, constant = 0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const Points tenfold = noisyLine(10, seed), even = noisyLine(1, seed);
    growing += scoreOf(fitLine(tenfold, true), 400) <
               scoreOf(fitLine(tenfold, false), 400) - 10;
    constant += scoreOf(fitLine(even, false), 400) < scoreOf(fitLine(even, true), 400);
  }
  EXPECT_EQ(growing, 20);
  // A point or two far out can be outliers or a place of wide noise; occasionally the
  // latter is likelier.
  EXPECT_GE(constant, 18);
}

TEST(VariedNoise, IsOneWidthByDefault)
{
  const EmFit fit = fitLine(noisyLine(10, 1), false);
  ASSERT_EQ(fit.noises.size(), 1u);
  EXPECT_TRUE(fit.noises[0].empty());
  EXPECT_EQ(fit.width_cost, 0);
}

TEST(VariedNoise, ARingInThePlaneIsClosedThroughItsNoisySide)
{
  for (unsigned seed = 1; seed <= 3; ++seed) {
    SCOPED_TRACE(seed);
    boost::random::mt19937 random(seed);
    boost::random::uniform_real_distribution<double> turn(-M_PI, M_PI);
    boost::random::normal_distribution<double> normal;
    Points points;
    for (int i = 0; i < 500; ++i) {
      const double t = turn(random);
      const double noise = 0.03 * std::pow(20, std::pow(std::sin(t / 2), 4));
      const double r = 5 + noise * normal(random);
      points.emplace_back(r * std::cos(t), r * std::sin(t), 0);
    }
    const CurveNetwork network = reconstructRefined(points);
    ASSERT_EQ(network.curves.size(), 1u);
    EXPECT_TRUE(network.curves[0].closed);
    double quiet = 0, noisy = 0;
    for (const Point& p : network.curves[0].points) {
      double& worst = p.x() > 0 ? quiet : noisy;
      worst = std::max(worst, std::abs(p.norm() - 5));
    }
    // The noise is 0.03 to 0.064 on the right, up to 0.6 on the left.
    EXPECT_LT(quiet, 2 * 0.064);
    EXPECT_LT(noisy, 0.6);
  }
}

} // namespace
