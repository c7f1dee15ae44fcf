// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "curves/network/simpler_networks.h"

using namespace linelet;

namespace {

ModelCurve
straight(const Point& from, const Point& to)
{
  ModelCurve curve;
  curve.nodes = {from, to};
  return resampled(curve, 0.1);
}

TEST(SimplerNetworks, NothingIsSimplerThanOneCurveWithoutEndsOrWithFarOnes)
{
  EXPECT_TRUE(simplerNetworks({}, 0.2).empty());
  EXPECT_TRUE(simplerNetworks({straight({0, 0, 0}, {10, 0, 0})}, 0.2).empty());
  ModelCurve ring;
  for (int k = 0; k < 60; ++k)
    ring.nodes.emplace_back(std::cos(k * M_PI / 30), std::sin(k * M_PI / 30), 0);
  ring.closed = true;
  EXPECT_TRUE(simplerNetworks({ring}, 0.2).empty());
}

TEST(SimplerNetworks, ARingIsClosedWithoutItsStrayEnds)
{
  // Three quarters of a turn and more, with an outward spur at either end.
  ModelCurve ring;
  for (int k = 2; k <= 58; ++k)
    ring.nodes.emplace_back(
        5 * std::cos(k * M_PI / 30), 5 * std::sin(k * M_PI / 30), 0);
  const Point first = ring.nodes.front(), last = ring.nodes.back();
  ring.nodes.insert(ring.nodes.begin(), first + Point(0.7, 0, 0));
  ring.nodes.push_back(last + Point(-0.7, 0, 0));
  ring = resampled(ring, 0.1);
  double least = 1e9; // of the largest distances from the circle
  for (const ModelCurves& network : simplerNetworks({ring}, 0.25)) {
    ASSERT_EQ(network.size(), 1u);
    EXPECT_TRUE(network[0].closed);
    double most = 0;
    for (const Point& node : network[0].nodes)
      most = std::max(most, std::abs(node.norm() - 5));
    least = std::min(least, most);
  }
  // The chord over the gap and the cut-off ends, about 2.7 long, sags by 2.7^2 / 40.
  EXPECT_LT(least, 0.2);
}

TEST(SimplerNetworks, AWideGapIsBridgedOnlyWhereTheEndsAgree)
{
  // A bridge through empty space costs the fit less than the ends it saves.
  const auto joined = [](const Point& from, const Point& to) {
    const auto networks =
        simplerNetworks({straight({0, 0, 0}, {20, 0, 0}), straight(from, to)}, 1);
    return std::any_of(
        networks.begin(), networks.end(), [](const ModelCurves& network) {
          return network.size() == 1 && length(network[0]) > 30;
        });
  };
  EXPECT_TRUE(joined({21, 1, 0}, {21, 20, 0})) << "a corner";
  EXPECT_TRUE(joined({25, 0, 0}, {45, 0, 0})) << "a hole in a line";
  EXPECT_FALSE(joined({21, 5, 0}, {21, 25, 0})) << "a corner far from either end";
}

TEST(SimplerNetworks, EveryShortCurveIsLeftOutOnce)
{
  const ModelCurve line = straight({0, 0, 0}, {10, 0, 0});
  ModelCurve spur = straight({5, 0, 0}, {5, 1.5, 0});
  spur.junction[0] = 0;
  const auto networks = simplerNetworks({line, spur}, 0.05);
  ASSERT_EQ(networks.size(), 1u);
  ASSERT_EQ(networks[0].size(), 1u);
  EXPECT_EQ(networks[0][0].nodes, line.nodes);
}

} // namespace
