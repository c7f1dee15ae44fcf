// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// Scans unlike a clean tile: what they lack or have too much of must not hide the
// wires.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <linelet/powerline/extract_power_lines.h>

#include "powerline/scene_builder.h"

namespace linelet::powerline {
namespace {

using test::SceneBuilder;

/** A span of four conductors and an earth wire between two pylons, 240 m apart. */
struct Line : SceneBuilder {
  static constexpr double length = 240, a = 900;

  std::vector<std::pair<Point, Point>> wires;

  explicit Line(std::uint32_t seed, double per_meter = 4, double noise = 0.04)
      : SceneBuilder(seed)
  {
    for (const double y : {-7.0, -3.0, 3.0, 7.0}) {
      wires.push_back({{0, y, 22}, {length, y, 22}});
      wire(wires.back().first, wires.back().second, a, per_meter, noise);
    }
  }

  void
  terrain()
  {
    ground(-30, -40, length + 30, 40, 4);
  }

  void
  pylons()
  {
    pylon({0, 0, 0}, 28);
    pylon({length, 0, 0}, 28);
  }
};

/** How many of \a line's wires lie within \a reach of a single vector for a share
 * \a part of their length. */
std::size_t
countFound(const PowerLineNetwork& n, const Line& line, double reach, double part = 0.9)
{
  return static_cast<std::size_t>(
      std::count_if(line.wires.begin(), line.wires.end(), [&](const auto& truth) {
        return std::any_of(n.wires.begin(), n.wires.end(), [&](const Wire& wire) {
          int near = 0;
          for (int k = 0; k <= 100; ++k) {
            const Point p = SceneBuilder::onWire(
                truth.first, truth.second, Line::a, Line::length * k / 100);
            const double s = wire.curve.along(p);
            near += s >= wire.curve.from - 1 && s <= wire.curve.to + 1 &&
                    wire.curve.distance(p) <= reach;
          }
          return near >= part * 101;
        });
      }));
}

// Noise that scatters beyond the tube of a wire is not another wire beside it.
TEST(UnlikeScan, OfMuchNoiseShowsEachWireOnce)
{
  for (const std::uint32_t seed : {1U, 2U, 3U})
    for (const double noise : {0.08, 0.12}) {
      SCOPED_TRACE(testing::Message() << "seed " << seed << ", noise " << noise);
      Line line(seed, 8, noise);
      line.terrain();
      line.pylons();
      const PowerLineNetwork network = extractPowerLines(line.points);
      EXPECT_EQ(countFound(network, line, 3 * noise), line.wires.size());
      EXPECT_EQ(network.wires.size(), line.wires.size());
    }
}

// Below and beside the lowest wire over water there are only other wires, of its bundle
// and of the arm above, and no roof.
TEST(UnlikeScan, OfARiverThatReturnsNothing)
{
  constexpr double span = 500, a = 2000;
  const Point from[] = {{0, -8, 40}, {0, -9.3, 45}, {0, 8, 40}, {0, 8.45, 40}};
  const Point to(span, 0, 0);
  for (const double degrees : {0.0, 33.0}) {
    SceneBuilder scene(41);
    scene.ground(-60, -40, 60, 40, 3);
    scene.ground(span - 60, -40, span + 60, 40, 3);
    for (const Point& begin : from)
      scene.wire(begin, begin + to, a, 3, 0.03);
    const Eigen::Rotation2Dd turn(degrees / 180 * std::acos(-1.0));
    for (Point& p : scene.points)
      p.head<2>() = turn * p.head<2>();
    const PowerLineNetwork n = extractPowerLines(scene.points);
    for (const Point& begin : from) {
      int covered = 0;
      for (int k = 5; k <= 95; ++k) {
        Point p = SceneBuilder::onWire(begin, begin + to, a, span * k / 100);
        p.head<2>() = turn * p.head<2>();
        covered += std::any_of(n.wires.begin(), n.wires.end(), [&](const Wire& wire) {
          return wire.curve.distance(p) < 0.1;
        });
      }
      EXPECT_GT(covered, 85) << "of 91 places, heading " << degrees << ", wire at "
                             << begin.transpose();
    }
  }
}

TEST(UnlikeScan, WithoutPylonsIsASpanWithoutSupports)
{
  Line line(1);
  line.terrain();
  const PowerLineNetwork n = extractPowerLines(line.points);
  EXPECT_EQ(n.wires.size(), 4U);
  EXPECT_EQ(countFound(n, line, 0.1), 4U);
  EXPECT_TRUE(n.supports.empty());
}

TEST(UnlikeScan, WithoutGroundHasTreesToStandOn)
{
  Line line(2);
  line.pylons();
  for (int i = 0; i < 150; ++i) {
    const Point at(line.uniform(-30, 270), line.uniform(12, 40), 0);
    line.box(at - Point(2, 2, 0), at + Point(2, 2, line.uniform(3, 9)), 200);
  }
  EXPECT_EQ(countFound(extractPowerLines(line.points), line, 0.1), 4U);
}

TEST(UnlikeScan, WithNoiseFarBelowAndAboveIsAsWithout)
{
  Line line(3);
  line.terrain();
  line.pylons();
  for (int i = 0; i < 60; ++i)
    line.points.emplace_back(line.uniform(-30, 270),
                             line.uniform(-40, 40),
                             i % 2 == 0 ? -line.uniform(20, 150)
                                        : line.uniform(60, 500));
  const PowerLineNetwork n = extractPowerLines(line.points);
  EXPECT_EQ(n.wires.size(), 4U);
  EXPECT_EQ(countFound(n, line, 0.1), 4U);
}

// One stray point must not turn the whole scene into one cell.
TEST(UnlikeScan, WithPointsInAnotherCountryIsAsWithout)
{
  Line line(4);
  line.terrain();
  line.pylons();
  line.points.emplace_back(2e6, -3e6, 5);
  line.points.emplace_back(-4e5, 0, 9000);
  EXPECT_EQ(countFound(extractPowerLines(line.points), line, 0.1), 4U);
}

TEST(UnlikeScan, WithEveryPointTwiceIsAsOnce)
{
  Line line(5);
  line.terrain();
  line.pylons();
  const Points once = line.points;
  line.points.insert(line.points.end(), once.begin(), once.end());
  EXPECT_EQ(countFound(extractPowerLines(line.points), line, 0.1), 4U);
}

// Misaligned strips show every wire twice, too close together to be told apart.
TEST(UnlikeScan, OfStripsThatDoNotFitHasItsWiresBetweenThem)
{
  for (const double apart : {0.1, 0.2}) {
    Line line(6, 2);
    line.terrain();
    line.pylons();
    const std::size_t half = line.points.size();
    Line again(7, 2);
    again.terrain();
    again.pylons();
    const Point off = apart * Point(0.3, 0.8, 0.5);
    for (const Point& p : again.points)
      line.points.push_back(p + off);
    ASSERT_GT(line.points.size(), half);
    const PowerLineNetwork n = extractPowerLines(line.points);
    EXPECT_EQ(countFound(n, line, apart + 0.1), 4U) << apart;
  }
}

TEST(UnlikeScan, WithTreesGrownIntoTheWiresStillShowsThem)
{
  Line line(8);
  line.terrain();
  line.pylons();
  for (const double x : {60.0, 150.0})
    line.box({x - 4, -10, 8}, {x + 4, 10, 24}, 3000);
  EXPECT_EQ(countFound(extractPowerLines(line.points), line, 0.1, 0.8), 4U);
}

// An earth wire is thinner and sags less: a sparse scan hits it once in ten meters,
// which is not linear around any of its points.
TEST(UnlikeScan, WithFewPointsOnTheEarthWireFindsItByItsLine)
{
  Line line(9, 1.5);
  line.terrain();
  line.pylons();
  const std::pair<Point, Point> earth = {{0, 0, 28}, {Line::length, 0, 28}};
  const double flatter = 1150;
  for (double s = 4; s < Line::length; s += 7)
    line.points.push_back(
        SceneBuilder::onWire(
            earth.first, earth.second, flatter, s + line.uniform(0, 5)) +
        Point(0, line.normal(0.04), line.normal(0.04)));
  const PowerLineNetwork n = extractPowerLines(line.points);
  ASSERT_EQ(n.wires.size(), 5U);
  const auto found = std::max_element(
      n.wires.begin(), n.wires.end(), [](const Wire& x, const Wire& y) {
        return x.curve.lowest.z() < y.curve.lowest.z();
      });
  EXPECT_NEAR(found->curve.a, flatter, 80);
  EXPECT_GT(found->length, 220);
}

// Two conductors half a meter apart, each seen on one half of the span only: no pylon
// stands where one ends and the other begins, since the rest of the line runs past.
TEST(UnlikeScan, WithAWireBrokenInTheMiddleHasNoPylonThere)
{
  Line line(10);
  line.terrain();
  line.pylons();
  line.wire({0, 0, 26}, {Line::length, 0, 26}, 900, 4, 0.04, 118, 240);
  line.wire({0, 0, 26.4}, {Line::length, 0.4, 26.4}, 900, 4, 0.04, 0, 122);
  const PowerLineNetwork n = extractPowerLines(line.points);
  for (const Support& support : n.supports)
    EXPECT_GT(std::abs(support.base.x() - 120), 100) << support.base.x();
  EXPECT_EQ(n.spans.size(), 1U);
}

} // namespace
} // namespace linelet::powerline
