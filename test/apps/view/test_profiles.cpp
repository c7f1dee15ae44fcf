// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

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

} // namespace
