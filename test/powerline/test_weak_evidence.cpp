// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// What can still be inferred from few points or points that merge: poles and bundles.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <linelet/powerline/extract_power_lines.h>

#include "powerline/scene_builder.h"

namespace linelet::powerline {
namespace {

using test::SceneBuilder;

/** A low line of four wires over a pole in a dip. The wires have no kink there: one
 * parabola fits both spans, so that only the pole itself reveals it. */
class PoleInADip : public testing::Test {
protected:
  static constexpr double reach = 35, top = 10, rise = 3;
  static constexpr double a = reach * reach / (2 * rise);
  SceneBuilder scene_{7};

  PoleInADip()
  {
    scene_.ground(-36, -15, 36, 15, 6);
    for (const double y : {-0.75, -0.25, 0.25, 0.75})
      for (const double x : {-reach, reach})
        scene_.wire({x, y, top + rise}, {0, y, top}, a, 8, 0.02);
  }

  /** \brief The wires attached to a support near the pole. */
  static std::size_t
  endsAtPole(const PowerLineNetwork& network)
  {
    std::size_t count = 0;
    for (const Wire& wire : network.wires)
      for (const auto& [end, support] : {std::pair(wire.front, wire.front_support),
                                         std::pair(wire.back, wire.back_support)})
        count += support != 0 && std::abs(end.x()) < 0.5 ? 1 : 0;
    return count;
  }
};

TEST_F(PoleInADip, IsSeenByFourPointsWhereNothingElseStands)
{
  for (const double z : {4.2, 4.4, 6.8, 9.4})
    scene_.points.emplace_back(scene_.normal(0.05), scene_.normal(0.05), z);
  const PowerLineNetwork network = extractPowerLines(scene_.points);
  EXPECT_EQ(network.wires.size(), 8u);
  EXPECT_EQ(endsAtPole(network), 8u);
  ASSERT_EQ(network.supports.size(), 1u);
  EXPECT_EQ(network.supports[0].kind, Support::Kind::Pole);
  EXPECT_LT(network.supports[0].base.head<2>().norm(), 0.3);
  EXPECT_GE(network.supports[0].points, 4u);
}

TEST_F(PoleInADip, IsNotInventedOfNothing)
{
  const PowerLineNetwork network = extractPowerLines(scene_.points);
  EXPECT_EQ(network.wires.size(), 4u);
  EXPECT_TRUE(network.supports.empty());
}

TEST_F(PoleInADip, IsNotSeenInATree)
{
  for (int i = 0; i < 60; ++i)
    scene_.points.emplace_back(
        scene_.normal(0.7), scene_.normal(0.7), scene_.uniform(3.5, 9.5));
  const PowerLineNetwork network = extractPowerLines(scene_.points);
  EXPECT_EQ(network.wires.size(), 4u);
  EXPECT_EQ(endsAtPole(network), 0u);
}

class BlurredBundle : public testing::TestWithParam<double> {};

TEST_P(BlurredBundle, IsDrawnInItsMiddleOrAsBothItsConductors)
{
  constexpr double half = 0.2, length = 200, sag_parameter = 1000;
  SceneBuilder scene(11);
  scene.ground(-10, -30, length + 10, 30, 4);
  const auto onWire = [&](double y, double s) {
    return SceneBuilder::onWire({0, y, 20}, {length, y, 20}, sag_parameter, s);
  };
  // Footprints nearly as wide as the conductor spacing, so there is hardly a gap.
  for (const double y : {-half, half})
    for (int i = 0; i < 8 * length; ++i)
      scene.points.push_back(
          onWire(y, scene.uniform(0, length)) +
          Point(0, scene.uniform(-GetParam(), GetParam()), scene.normal(0.02)));
  const PowerLineNetwork network = extractPowerLines(scene.points);
  ASSERT_FALSE(network.wires.empty());
  const auto nearest = [&](const Point& p) {
    double least = std::numeric_limits<double>::infinity();
    for (const Wire& wire : network.wires)
      least = std::min(least, wire.curve.distance(p));
    return least;
  };
  for (double s = 5; s < length; s += 10) {
    const double middle = nearest(onWire(0, s));
    const double both = std::max(nearest(onWire(-half, s)), nearest(onWire(half, s)));
    EXPECT_LT(std::min(middle, both), 0.1) << "at " << s;
  }
  for (const Wire& wire : network.wires)
    EXPECT_GT(wire.length, 0.9 * length) << wire.reason;
}

INSTANTIATE_TEST_SUITE_P(OfEveryWidth,
                         BlurredBundle,
                         testing::Values(0.08, 0.12, 0.14, 0.16, 0.18, 0.2));

/** A line in the open, then through crowns as dense as its wires. */
SceneBuilder
forestLine(std::uint32_t seed, bool goes_on)
{
  SceneBuilder scene(seed);
  scene.ground(-90, -25, 90, 25, 3);
  scene.box({2, -20, 3}, {88, 20, 13}, 26000);
  for (const double y : {-1.5, 0., 1.5}) {
    scene.wire({-90, y, 9}, {0, y, 9}, 600, 3, 0.03);
    if (goes_on)
      scene.wire({0, y, 9}, {90, y, 9}, 600, 0.8, 0.03);
  }
  return scene;
}

bool
isFoundAt(const PowerLineNetwork& network, const Point& p)
{
  return std::any_of(network.wires.begin(), network.wires.end(), [&](const Wire& wire) {
    const Points line = polyline(wire);
    for (std::size_t k = 1; k < line.size(); ++k) {
      const Point v = line[k] - line[k - 1];
      const double s = std::clamp(v.dot(p - line[k - 1]) / v.squaredNorm(), 0.0, 1.0);
      if ((line[k - 1] + s * v - p).norm() < 0.25)
        return true;
    }
    return false;
  });
}

TEST(NextSpan, IsFoundInCrowns)
{
  // Half of the points within 0.4 m of a wire there belong to crowns, and nothing is
  // linear.
  double found = 0, all = 0;
  for (const std::uint32_t seed : {1, 2, 3, 4}) {
    const PowerLineNetwork network = extractPowerLines(forestLine(seed, true).points);
    for (const double y : {-1.5, 0., 1.5})
      for (double x = 5; x < 85; x += 2) {
        const Point p = SceneBuilder::onWire({0, y, 9}, {90, y, 9}, 600, x);
        all += 1;
        found += isFoundAt(network, p);
      }
  }
  EXPECT_GE(found, 0.9 * all) << found / all;
}

TEST(NextSpan, IsNotInventedInCrowns)
{
  for (const std::uint32_t seed : {1, 2, 3})
    for (const Wire& wire : extractPowerLines(forestLine(seed, false).points).wires)
      EXPECT_LT(std::max(wire.front.x(), wire.back.x()), 10) << "seed " << seed;
}

/** A line of three spans of 60 m and three wires; crowns around the middle span, whose
 * wires are visible where \a shown says, with one point per meter. */
SceneBuilder
throughCrowns(std::uint32_t seed, const std::vector<std::pair<double, double>>& shown)
{
  SceneBuilder scene(seed);
  scene.ground(-90, -25, 90, 25, 3);
  scene.box({-29, -20, 3}, {29, 20, 13}, 17000);
  for (const double y : {-1.5, 0., 1.5}) {
    scene.wire({-90, y, 9}, {-30, y, 9}, 600, 3, 0.03);
    scene.wire({30, y, 9}, {90, y, 9}, 600, 3, 0.03);
    for (const auto& [from, to] : shown)
      for (double s = from; s < to; s += 1)
        scene.points.push_back(
            SceneBuilder::onWire(
                {-30, y, 9}, {30, y, 9}, 600, scene.uniform(from, to)) +
            Point(0, scene.normal(0.03), scene.normal(0.03)));
  }
  return scene;
}

// Both ends are known, so three quarters of a sparse wire between them suffice.
TEST(SpanBetween, IsFoundInCrowns)
{
  double found = 0, all = 0;
  for (const std::uint32_t seed : {1, 2, 3, 4}) {
    const PowerLineNetwork network =
        extractPowerLines(throughCrowns(seed, {{3, 26}, {36, 57}}).points);
    for (const double y : {-1.5, 0., 1.5})
      for (double x = 1; x < 60; x += 2) {
        all += 1;
        found +=
            isFoundAt(network, SceneBuilder::onWire({-30, y, 9}, {30, y, 9}, 600, x));
      }
  }
  EXPECT_GE(found, 0.9 * all) << found / all;
}

TEST(SpanBetween, IsNotInventedInCrowns)
{
  for (const std::uint32_t seed : {1, 2, 3})
    for (const Wire& wire : extractPowerLines(throughCrowns(seed, {}).points).wires) {
      const double middle = (wire.front.x() + wire.back.x()) / 2;
      EXPECT_GT(std::abs(middle), 30) << "seed " << seed;
    }
}

} // namespace
} // namespace linelet::powerline
