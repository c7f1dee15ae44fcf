// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include <linelet/curves/integration_scheme.h>

#include "curves/streamline/adaptive_dop853.h"

using namespace linelet;

namespace {

/** \brief Directions of helices around the z axis, of slope 1. */
Point
helixField(const Point& x)
{
  const double r = std::hypot(x.x(), x.y());
  return Point(-x.y() / r, x.x() / r, 1) / std::sqrt(2.0);
}

Point
helix(double length)
{
  const double t = length / std::sqrt(2.0);
  return {std::cos(t), std::sin(t), t};
}

StepControl
control(double tolerance)
{
  return {tolerance, 0.1, 1e-6, 100};
}

/** \brief The largest error over a length of 20, with output at every \a interval. */
double
largestError(double tolerance, double interval, std::size_t& evaluations)
{
  AdaptiveDop853 line(helix(0), control(tolerance));
  double worst = 0;
  for (int i = 1; i * interval <= 20; ++i)
    worst = std::max(worst,
                     (line.advance(interval, helixField) - helix(i * interval)).norm());
  evaluations = line.evaluations();
  return worst;
}

} // namespace

TEST(AdaptiveDop853, KeepsItsToleranceWithFewEvaluations)
{
  // The errors and evaluations of SciPy 1.17's DOP853, with the same tolerances and
  // output every half length.
  const struct {
    double tolerance, error;
    std::size_t evaluations;
  } peers[] = {{1e-3, 1.21e-2, 142},
               {1e-5, 6.37e-4, 187},
               {1e-7, 5.97e-5, 220},
               {1e-9, 8.42e-7, 313},
               {1e-11, 1.61e-9, 598}};
  std::size_t last = 0;
  for (const auto& peer : peers) {
    std::size_t evaluations = 0;
    EXPECT_LT(largestError(peer.tolerance, 0.5, evaluations), 1.5 * peer.error);
    EXPECT_LT(evaluations, 1.5 * static_cast<double>(peer.evaluations));
    EXPECT_GT(evaluations, last) << "as accurate for less";
    last = evaluations;
  }
  // Euler would need 1e12 steps for 1e-11, rk4 20,000 evaluations.
  EXPECT_LT(last, 1500u);
}

TEST(AdaptiveDop853, DenseOutputIsAsGoodAsTheSteps)
{
  // The same steps, with output at few and at many places.
  std::size_t few = 0, many = 0;
  const double coarse = largestError(1e-8, 4, few);
  const double fine = largestError(1e-8, 0.01, many);
  EXPECT_EQ(few, many) << "output adds no steps";
  EXPECT_LT(fine, 20 * std::max(coarse, 1e-9));
}

TEST(AdaptiveDop853, AStraightFieldIsCrossedInTheLongestSteps)
{
  StepControl limits = control(1e-6);
  limits.most = 5;
  AdaptiveDop853 line(Point(1, 2, 3), limits);
  const Point direction = Point(1, 2, 2) / 3;
  const Point end = line.advance(100, [&](const Point&) { return direction; });
  EXPECT_LT((end - (Point(1, 2, 3) + 100 * direction)).norm(), 1e-12);
  EXPECT_LE(line.evaluations(), 16u * 24u);
}

TEST(AdaptiveDop853, ARoughFieldIsCrossedInTheShortestSteps)
{
  // A discontinuous direction: no step across it is ever accurate, yet it ends.
  StepControl limits = control(1e-12);
  limits.least = 0.01;
  AdaptiveDop853 line(Point(0, 0, 0), limits);
  const auto field = [](const Point& x) {
    return x.x() < 1.005 ? Point(1, 0, 0) : Point(0, 1, 0);
  };
  const Point end = line.advance(2, field);
  EXPECT_TRUE(end.allFinite());
  EXPECT_NEAR(end.x(), 1.005, 0.02);
  EXPECT_NEAR(end.y(), 0.995, 0.02);
}

TEST(AdaptiveDop853, AgreesWithTheConstantStepsOfTheScheme)
{
  // Restricted to one step length, it is the plain scheme.
  StepControl limits = control(1);
  limits.least = limits.most = limits.first = 0.25;
  AdaptiveDop853 line(helix(0), limits);
  Point x = helix(0);
  for (int i = 0; i < 40; ++i) {
    x += integrationStep(butcherTable(IntegrationScheme::Dop853), x, 0.25, helixField);
    EXPECT_LT((line.advance(0.25, helixField) - x).norm(), 1e-12);
  }
}
