// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include <linelet/powerline/extract_power_lines.h>

#include "powerline/scene_builder.h"

namespace linelet::powerline {
namespace {

using test::SceneBuilder;

/** Two spans of three wires over a pylon at (200, 0), seen up to x = 0 and x = 380. */
struct TwoSpans {
  SceneBuilder scene{41};
  std::vector<std::pair<Point, Point>> wires;
  static constexpr double a = 900;

  explicit TwoSpans(double per_meter = 4, double gap_from = 0, double gap_to = 0)
  {
    scene.ground(-10, -30, 390, 30, 4);
    scene.pylon({200, 0, 0}, 30);
    for (const double y : {-6.0, 0.5, 6.0}) {
      const double z = y == 0.5 ? 27 : 21;
      wires.push_back({{0, y, z + 3}, {200, y, z}});
      wires.push_back({{200, y, z}, {380, y, z + 1}});
    }
    for (const auto& [from, to] : wires)
      scene.wire(from, to, a, per_meter, 0.04, gap_from, gap_to);
  }
};

double
farthest(const Wire& wire, const std::pair<Point, Point>& truth)
{
  double worst = 0;
  const double length = (truth.second - truth.first).head<2>().norm();
  for (double s = 0; s <= length; s += 2)
    worst = std::max(worst,
                     wire.curve.distance(SceneBuilder::onWire(
                         truth.first, truth.second, TwoSpans::a, s)));
  return worst;
}

TEST(ExtractPowerLines, FindsEveryWireOfTwoSpansAndTheirPylon)
{
  const TwoSpans line;
  const PowerLineNetwork n = extractPowerLines(line.scene.points);
  ASSERT_EQ(n.wires.size(), 6u);
  EXPECT_EQ(n.spans.size(), 2u);
  EXPECT_EQ(n.circuits.size(), 1u);
  ASSERT_EQ(n.supports.size(), 1u);
  EXPECT_NEAR(n.supports[0].base.x(), 200, 1);
  EXPECT_NEAR(n.supports[0].base.y(), 0, 1.5);
  EXPECT_NEAR(n.supports[0].height, 30, 1);
  EXPECT_EQ(n.supports[0].kind, Support::Kind::Pylon);
  EXPECT_GT(n.supports[0].points, 200u);
  for (const auto& truth : line.wires) {
    const auto found = std::min_element(
        n.wires.begin(), n.wires.end(), [&](const Wire& x, const Wire& y) {
          const Point middle = (truth.first + truth.second) / 2;
          return ((x.front + x.back) / 2 - middle).norm() <
                 ((y.front + y.back) / 2 - middle).norm();
        });
    EXPECT_LT(farthest(*found, truth), 0.06);
    const bool first = truth.first.x() < 1;
    const Point attachment = first ? truth.second : truth.first;
    EXPECT_LT(
        std::min((found->front - attachment).norm(), (found->back - attachment).norm()),
        0.5);
    EXPECT_NEAR(found->span_length, first ? 200 : 180, 1.5);
    EXPECT_NEAR(found->curve.a, TwoSpans::a, 60);
    EXPECT_GT(found->confidence, 0.8);
    EXPECT_TRUE(found->reason.empty()) << found->reason;
  }
}

TEST(ExtractPowerLines, OrdersSpansAndKeepsNumbersOfConductors)
{
  const TwoSpans line;
  const PowerLineNetwork n = extractPowerLines(line.scene.points);
  ASSERT_EQ(n.spans.size(), 2u);
  for (std::size_t i = 0; i < n.wires.size(); ++i)
    EXPECT_EQ(n.wires[i].id, static_cast<int>(i) + 1);
  EXPECT_EQ(n.spans[0].to_support, 1);
  EXPECT_EQ(n.spans[1].from_support, 1);
  EXPECT_EQ(n.circuits[0].spans, (std::vector<int>{1, 2}));
  EXPECT_EQ(n.circuits[0].supports, (std::vector<int>{0, 1, 0}));
  for (const Span& span : n.spans)
    ASSERT_EQ(span.wires.size(), 3u);
  for (std::size_t k = 0; k < 3; ++k) {
    const Wire& before = n.wires[static_cast<std::size_t>(n.spans[0].wires[k] - 1)];
    const Wire& after = n.wires[static_cast<std::size_t>(n.spans[1].wires[k] - 1)];
    EXPECT_EQ(before.number, after.number);
    EXPECT_EQ(before.back, after.front); // one attachment point, exactly
    EXPECT_EQ(polyline(before).back(), polyline(after).front());
  }
}

TEST(ExtractPowerLines, LabelsPointsWithTheirWire)
{
  const TwoSpans line;
  std::vector<std::uint8_t> classes(line.scene.points.size(), 3);
  const PowerLineNetwork n = extractPowerLines(line.scene.points, classes);
  for (std::size_t i = 0; i < classes.size(); ++i) {
    const bool wire = n.classes[i] == wire_class;
    EXPECT_EQ(wire, n.wire_id[i] != 0);
    EXPECT_EQ(wire, n.span_id[i] != 0);
    EXPECT_EQ(wire, !std::isnan(n.wire_distance[i]));
    if (!wire) {
      EXPECT_TRUE(n.classes[i] == 3 || n.classes[i] == pylon_class);
      continue;
    }
    const Wire& w = n.wires[static_cast<std::size_t>(n.wire_id[i] - 1)];
    EXPECT_EQ(w.span, n.span_id[i]);
    EXPECT_NEAR(n.wire_distance[i], w.curve.distance(line.scene.points[i]), 1e-5);
  }
}

TEST(ExtractPowerLines, BridgesAGapButNoneLongerThanAllowed)
{
  const TwoSpans line(4, 80, 105); // 25 m without a point in every wire
  PowerLineSettings settings;
  const PowerLineNetwork whole = extractPowerLines(line.scene.points, {}, settings);
  EXPECT_EQ(whole.wires.size(), 6u);
  for (const Wire& wire : whole.wires) {
    EXPECT_NEAR(wire.largest_gap, 25, 1.5);
    EXPECT_FALSE(wire.reason.empty());
  }
  settings.max_gap = 15;
  const PowerLineNetwork split = extractPowerLines(line.scene.points, {}, settings);
  EXPECT_EQ(split.wires.size(), 12u);
  for (const Wire& wire : split.wires)
    EXPECT_LE(wire.largest_gap, 15);
}

TEST(ExtractPowerLines, SparseWiresCarryALowerConfidence)
{
  const TwoSpans dense(4), sparse(0.6);
  const PowerLineNetwork good = extractPowerLines(dense.scene.points);
  const PowerLineNetwork poor = extractPowerLines(sparse.scene.points);
  ASSERT_FALSE(poor.wires.empty());
  for (const Wire& wire : poor.wires) {
    EXPECT_LT(wire.confidence, 0.85);
    EXPECT_FALSE(wire.reason.empty());
    for (const Wire& other : good.wires)
      EXPECT_LT(wire.confidence, other.confidence);
  }
}

// An earth wire is thin: of 300 m, a national scan shows 50 points.
TEST(ExtractPowerLines, FindsAnEarthWireOfFewPoints)
{
  SceneBuilder scene{43};
  scene.ground(-10, -30, 310, 30, 2);
  for (const double y : {-6.0, 0.0, 6.0})
    scene.wire({0, y, 21}, {300, y, 22}, TwoSpans::a, 0.6, 0.04);
  const std::pair<Point, Point> earth = {{0, 0, 36}, {300, 0, 37}};
  scene.wire(earth.first, earth.second, TwoSpans::a, 0.17, 0.04);
  const PowerLineNetwork n = extractPowerLines(scene.points);
  ASSERT_EQ(n.wires.size(), 4u);
  const Wire& highest = *std::max_element(
      n.wires.begin(), n.wires.end(), [](const Wire& x, const Wire& y) {
        return x.front.z() < y.front.z();
      });
  EXPECT_LT(farthest(highest, earth), 0.1);
}

TEST(ExtractPowerLines, MeasuresClearances)
{
  TwoSpans line;
  // A tree top 2 m below the middle of the first outer wire.
  const Point middle =
      SceneBuilder::onWire({0, -6, 24}, {200, -6, 21}, TwoSpans::a, 100);
  line.scene.box(middle - Point(2, 2, 8), middle - Point(-2, -2, 2), 400);
  const PowerLineNetwork n = extractPowerLines(line.scene.points);
  double ground = 1e9, vegetation = 1e9;
  Clearance nearest;
  for (const Wire& wire : n.wires) {
    ground = std::min(ground, wire.ground.distance);
    if (wire.vegetation.known() && wire.vegetation.distance < vegetation) {
      vegetation = wire.vegetation.distance;
      nearest = wire.vegetation;
    }
  }
  double lowest = 1e9;
  for (const auto& [from, to] : line.wires)
    for (double s = 0; s <= (to - from).head<2>().norm(); s += 1)
      lowest = std::min(lowest, SceneBuilder::onWire(from, to, TwoSpans::a, s).z());
  EXPECT_NEAR(ground, lowest, 0.1);
  EXPECT_NEAR(vegetation, 2, 0.4);
  EXPECT_LT((nearest.other - middle).head<2>().norm(), 3);
}

// Where a scan ends, a stub of a twin strand remains that is too short for a wire; it
// must not become a tree at half a meter.
TEST(ExtractPowerLines, AStubAtAFreeEndIsNotATree)
{
  TwoSpans line;
  for (int i = 0; i < 8; ++i)
    line.scene.points.push_back(Point(0.1 * i, -5.5, 24));
  const PowerLineNetwork n = extractPowerLines(line.scene.points);
  ASSERT_EQ(n.wires.size(), 6u);
  for (const Wire& wire : n.wires)
    if (wire.vegetation.known()) {
      EXPECT_GT(wire.vegetation.distance, 2) << "wire " << wire.id;
    }
}

// Four conductors 0.45 m apart with one point per meter each look like a line nowhere.
TEST(ExtractPowerLines, FollowsThinBundlesOfFour)
{
  SceneBuilder scene(41);
  scene.ground(0, 0, 300, 40, 3);
  for (const double y : {-0.225, 0.225})
    for (const double z : {-0.225, 0.225})
      scene.wire({0, 20 + y, 30 + z}, {300, 20 + y, 30 + z}, 1500, 1, 0.03);
  const PowerLineNetwork n = extractPowerLines(scene.points);
  ASSERT_FALSE(n.wires.empty());
  double longest = 0;
  for (const Wire& wire : n.wires) {
    longest = std::max(longest, wire.length);
    for (const Point& p : polyline(wire))
      EXPECT_NEAR(p.y(), 20, 0.32);
  }
  EXPECT_GT(longest, 290);
}

TEST(ExtractPowerLines, FindsNothingInAnEmptyScene)
{
  const auto expectNone = [](const Points& points, const char* what) {
    const PowerLineNetwork n = extractPowerLines(points);
    EXPECT_TRUE(n.wires.empty()) << what << ": " << n.wires.size();
    EXPECT_TRUE(n.spans.empty() && n.circuits.empty()) << what;
    EXPECT_TRUE(n.supports.empty()) << what;
    EXPECT_EQ(n.classes, std::vector<std::uint8_t>(points.size(), 0)) << what;
    EXPECT_EQ(n.wire_id.size(), points.size());
  };
  expectNone({}, "nothing");
  expectNone({{1, 2, 3}}, "one point");
  expectNone(Points(200, Point(4, 5, 6)), "coincident points");
  SceneBuilder ground(1);
  ground.ground(0, 0, 100, 100, 5);
  expectNone(ground.points, "ground");
  SceneBuilder roof(2);
  roof.ground(0, 0, 100, 100, 6);
  roof.box({30, 30, 6}, {70, 60, 6.05}, 40 * 30 * 6);
  expectNone(roof.points, "a flat roof");
  SceneBuilder gable(3);
  gable.ground(0, 0, 100, 100, 6);
  for (int i = 0; i < 6000; ++i) {
    const double x = gable.uniform(25, 75), y = gable.uniform(-8, 8);
    gable.points.emplace_back(x, 50 + y, 5 + 5 * (1 - std::abs(y) / 8));
  }
  expectNone(gable.points, "a gabled roof");
  SceneBuilder forest(4);
  forest.ground(0, 0, 80, 80, 3);
  forest.box({0, 0, 2}, {80, 80, 18}, 60000);
  expectNone(forest.points, "a forest");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  expectNone({{nan, 1, 2}, {1, nan, 2}, {3, 4, nan}}, "NaN");
}

TEST(ExtractPowerLines, LeavesPointsThatAreNotFiniteAlone)
{
  TwoSpans line;
  const PowerLineNetwork plain = extractPowerLines(line.scene.points);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  line.scene.points.push_back({nan, 0, 20});
  line.scene.points.push_back({100, 0, std::numeric_limits<double>::infinity()});
  const PowerLineNetwork n = extractPowerLines(line.scene.points);
  ASSERT_EQ(n.wires.size(), plain.wires.size());
  EXPECT_EQ(n.classes[line.scene.points.size() - 2], 0);
  EXPECT_EQ(n.classes.back(), 0);
}

TEST(ExtractPowerLines, DoesNotDependOnThreads)
{
  const TwoSpans line;
  PowerLineSettings settings;
  settings.threads = 1;
  const PowerLineNetwork one = extractPowerLines(line.scene.points, {}, settings);
  for (const unsigned threads : {2U, 5U}) {
    settings.threads = threads;
    const PowerLineNetwork many = extractPowerLines(line.scene.points, {}, settings);
    EXPECT_EQ(one.classes, many.classes);
    EXPECT_EQ(one.wire_id, many.wire_id);
    ASSERT_EQ(one.wires.size(), many.wires.size());
    for (std::size_t w = 0; w < one.wires.size(); ++w) {
      EXPECT_EQ(one.wires[w].curve.a, many.wires[w].curve.a);
      EXPECT_EQ(one.wires[w].front, many.wires[w].front);
      EXPECT_EQ(one.wires[w].rms, many.wires[w].rms);
    }
  }
}

TEST(ExtractPowerLines, RefusesInvalidSettings)
{
  PowerLineSettings settings;
  settings.max_gap = -1;
  EXPECT_THROW(extractPowerLines(Points{}, {}, settings), std::invalid_argument);
  settings = {};
  settings.min_length = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(extractPowerLines(Points{}, {}, settings), std::invalid_argument);
  EXPECT_THROW(extractPowerLines(Points(3, Point::Zero()), {2}, {}),
               std::invalid_argument);
}

TEST(ExtractPowerLines, StopsOnRequest)
{
  struct Stop : ProgressMonitor {
    bool
    canceled() const override
    {
      return true;
    }
  } stop;
  const TwoSpans line;
  EXPECT_THROW(extractPowerLines(line.scene.points, {}, {}, &stop), Canceled);
}

} // namespace
} // namespace linelet::powerline
