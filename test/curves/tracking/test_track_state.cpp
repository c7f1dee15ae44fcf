// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// The filter compared with closed forms: a circle is its own prediction, and on a
// straight line it is the least-squares fit of a parabola.
#include <cmath>
#include <random>

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

#include "curves/tracking/track_state.h"

using namespace linelet;

namespace {

TEST(TrackState, FollowsACircleOfItsCurvature)
{
  TrackState state;
  state.at = {5, 0, 0};
  state.direction = {0, 1, 0};
  state.curvature = {-0.2, 0, 0};
  const double step = 0.001;
  const int steps = static_cast<int>(std::round(5 * M_PI / 2 / step));
  for (int k = 0; k < steps; ++k) {
    // The curvature turns with the tangent.
    state.advance(step, 0);
    const Point outward = Point(state.at.x(), state.at.y(), 0).normalized();
    state.curvature = -0.2 * outward;
  }
  EXPECT_NEAR(state.at.x(), 0, 0.01);
  EXPECT_NEAR(state.at.y(), 5, 0.01);
  EXPECT_NEAR(state.direction.norm(), 1, 1e-12);
}

TEST(TrackState, IsTheLeastSquaresParabolaWithoutAWalk)
{
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0, 0.05);
  TrackState state;
  state.covariance = Eigen::Vector3d(1e6, 1e6, 1e6).asDiagonal();
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  double x = 0;
  for (int k = 0; k < 60; ++k) {
    state.advance(0.1, 0);
    x += 0.1;
    const double y = noise(random);
    // Slopes so small that arc length along the curve is x.
    state.observe(Point(0, 1e-3 * y, 0) - Point(0, state.at.y(), 0), 1e-6, 1);
    const Eigen::Vector3d basis(1, x, 0.5 * x * x);
    normal += basis * basis.transpose();
    right += 1e-3 * y * basis;
  }
  const Eigen::Vector3d parabola = normal.ldlt().solve(right);
  EXPECT_NEAR(state.at.y(), parabola.dot(Eigen::Vector3d(1, x, 0.5 * x * x)), 1e-5);
  EXPECT_NEAR(state.direction.y(), parabola[1] + parabola[2] * x, 1e-4);
}

TEST(TrackState, TurnsBackToWhereItWas)
{
  TrackState state;
  state.curvature = {0, 0.01, 0};
  state.covariance << 1, 0.2, 0.1, 0.2, 2, 0.3, 0.1, 0.3, 3;
  const TrackState before = state;
  state.reverse();
  state.reverse();
  EXPECT_TRUE(state.covariance.isApprox(before.covariance));
  EXPECT_EQ(state.direction, before.direction);
  state.reverse();
  EXPECT_EQ(state.covariance(0, 1), -before.covariance(0, 1));
  EXPECT_EQ(state.covariance(0, 2), before.covariance(0, 2));
}

TEST(TrackState, APointThatIsNoneOfTheCurveChangesNothing)
{
  TrackState state;
  const TrackState before = state;
  state.observe({0, 1, 0}, 0.1, 0);
  EXPECT_EQ(state.at, before.at);
  EXPECT_TRUE(state.covariance.isApprox(before.covariance));
}

} // namespace
