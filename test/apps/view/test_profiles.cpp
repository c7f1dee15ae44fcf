// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>

#include <gtest/gtest.h>

#include "model/profiles.h"
#include "powerline/network_by_hand.h"

namespace {

using namespace linelet;
using namespace linelet::view;

// Along the axis from pylon to pylon; heights above the zero of the file.
TEST(SpanProfile, HasWiresPointsGroundAndClearances)
{
  powerline::PowerLineNetwork network = test::networkByHand();
  Scene scene;
  scene.cloud = test::cloudByHand(network);
  scene.points = scene.cloud.points;
  const SpanProfile profile = profileOf(scene, network, 1);
  EXPECT_NEAR(profile.length, 100, 1e-9);
  ASSERT_EQ(profile.wires.size(), 2u);
  EXPECT_NEAR(profile.wires[0].curve.front().along, 0, 1e-9);
  EXPECT_NEAR(profile.wires[0].curve.front().height, 120, 1e-9); // shift: 100 m
  EXPECT_NEAR(profile.wires[0].curve.back().along, 100, 1e-9);
  EXPECT_EQ(profile.wires[0].points.size(), 4u);
  EXPECT_EQ(profile.wires[1].points.size(), 4u);
  ASSERT_FALSE(profile.ground.empty());
  EXPECT_NEAR(profile.ground.front().height, 100, 1e-6);
  // Two to the ground, one to the tree.
  ASSERT_EQ(profile.clearances.size(), 3u);
  EXPECT_NEAR(profile.clearances[2].distance, 3, 1e-9);
  EXPECT_FALSE(profile.clearances[2].to_ground);
  EXPECT_NEAR(profile.clearances[2].from.along, 60, 1e-9);
  EXPECT_LE(profileOf(scene, network, 1, 5).others.size(), 5u);
}

// A straight curve 3 beside the truth, turned by 30 degrees at its end.
TEST(CurveErrors, DistanceAndAngle)
{
  CurveNetwork truth;
  truth.curves.emplace_back().points = {Point(-100, 0, 0), Point(100, 0, 0)};
  Curve curve;
  curve.points = {{0, 3, 0}, {1, 3, 0}, {2, 3, 0}};
  auto errors = errorsAlong(curve, truth);
  ASSERT_EQ(errors.size(), 3u);
  EXPECT_NEAR(errors[1].distance, 3, 1e-12);
  EXPECT_NEAR(errors[1].angle, 0, 1e-6);
  EXPECT_NEAR(errors[2].along, 2, 1e-12);
  const double c = std::cos(M_PI / 6), s = std::sin(M_PI / 6);
  curve.points = {{0, 0, 0}, {c, s, 0}};
  errors = errorsAlong(curve, truth);
  EXPECT_NEAR(errors[0].angle, 30, 1e-9);
  EXPECT_NEAR(errors[1].distance, 0.5, 1e-12);
}

TEST(CurveErrors, DegenerateCurves)
{
  CurveNetwork truth;
  EXPECT_TRUE(errorsAlong(Curve(), truth).empty());
  Curve point;
  point.points = {{1, 2, 3}};
  EXPECT_TRUE(std::isinf(errorsAlong(point, truth)[0].distance));
  truth.curves.emplace_back().points = {Point(1, 2, 3), Point(1, 2, 3)};
  EXPECT_EQ(errorsAlong(point, truth)[0].distance, 0);
  EXPECT_TRUE(std::isnan(errorsAlong(point, truth)[0].angle));
}

} // namespace
