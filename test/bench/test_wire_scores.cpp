// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_int_distribution.hpp>
#include <boost/random/uniform_real_distribution.hpp>
#include <gtest/gtest.h>

#include <bench/measures/wire_scores.h>

namespace {

using namespace linelet;
using namespace linelet::bench;

/** A true wire from x = 0 to x = 100 at a place across, attached at both ends. */
CorridorWire
trueWire(double y, int number, double length = 100)
{
  CorridorWire wire;
  wire.number = number;
  wire.points = {Point(0, y, 10), Point(0.5 * length, y, 10), Point(length, y, 10)};
  wire.front_attached = wire.back_attached = true;
  return wire;
}

CurveNetwork
lines(const std::vector<Points>& all)
{
  CurveNetwork network;
  for (const Points& points : all) {
    Curve curve;
    curve.points = points;
    network.curves.push_back(curve);
  }
  return network;
}

TEST(WireScores, APerfectResult)
{
  const WireScores s =
      scoreWires(lines({{Point(0, 0, 10), Point(100, 0, 10)}}), {trueWire(0, 1)});
  EXPECT_NEAR(s.true_length, 100, 1e-9);
  EXPECT_NEAR(s.covered_length, 100, 1e-9);
  EXPECT_NEAR(s.found_length, 100, 1e-9);
  EXPECT_EQ(s.false_length, 0);
  EXPECT_EQ(s.spans, 1U);
  EXPECT_EQ(s.spans_found, 1U);
  ASSERT_EQ(s.end_errors.size(), 2U);
  EXPECT_NEAR(s.end_errors[1], 0, 1e-9);
}

TEST(WireScores, NothingFound)
{
  const WireScores s = scoreWires({}, {trueWire(0, 1)});
  EXPECT_EQ(s.spans, 1U);
  EXPECT_EQ(s.spans_found, 0U);
  EXPECT_EQ(s.covered_length, 0);
  EXPECT_EQ(s.found_length, 0);
  EXPECT_TRUE(s.end_errors.empty());
}

TEST(WireScores, TheNearbyAndTheAstray)
{
  // 0.2 m to the side: the span is found, nothing is covered within 0.1 m, nothing is
  // false.
  const WireScores beside =
      scoreWires(lines({{Point(0, 0.2, 10), Point(100, 0.2, 10)}}), {trueWire(0, 1)});
  EXPECT_EQ(beside.spans_found, 1U);
  EXPECT_EQ(beside.covered_length, 0);
  EXPECT_EQ(beside.false_length, 0);
  // 3 m too long, half a meter of which is still near the wire's end.
  const WireScores beyond =
      scoreWires(lines({{Point(0, 0, 10), Point(103, 0, 10)}}), {trueWire(0, 1)});
  EXPECT_NEAR(beyond.false_length, 2.5, 0.26);
  EXPECT_NEAR(beyond.end_errors[1], 3, 1e-9);
}

TEST(WireScores, TwoHalvesAreNotASpan)
{
  const WireScores s = scoreWires(lines({{Point(0, 0, 10), Point(50, 0, 10)},
                                         {Point(50, 0, 10), Point(100, 0, 10)}}),
                                  {trueWire(0, 1)});
  EXPECT_NEAR(s.covered_length, 100, 1e-9);
  EXPECT_EQ(s.spans_found, 0U);
}

TEST(WireScores, OneVectorInTheMiddleOfATwinBundle)
{
  const std::vector<CorridorWire> twins = {trueWire(-0.2, 1), trueWire(0.2, 1)};
  const CurveNetwork middle = lines({{Point(0, 0, 10), Point(100, 0, 10)}});
  const WireScores s = scoreWires(middle, twins);
  EXPECT_NEAR(s.covered_length, 200, 1e-9);
  EXPECT_EQ(s.spans_found, 2U);
  EXPECT_NEAR(s.end_errors.back(), 0, 1e-9);
  // Two wires with different numbers are not a bundle.
  const WireScores apart = scoreWires(middle, {trueWire(-0.2, 1), trueWire(0.2, 2)});
  EXPECT_EQ(apart.covered_length, 0);
}

TEST(WireScores, RestsAtTheBorderAreNotRequired)
{
  const WireScores s = scoreWires({}, {trueWire(0, 1, 8)});
  EXPECT_EQ(s.spans, 0U);
  EXPECT_EQ(s.true_length, 0);
}

TEST(ClassScores, CountedByHand)
{
  const std::vector<std::uint8_t> truth = {14, 14, 14, 2, 2, 15, 14};
  const std::vector<std::uint8_t> found = {14, 14, 2, 14, 2, 14, 0};
  const ClassScores s = scoreClass(found, truth, 14);
  EXPECT_EQ(s.right, 2U);
  EXPECT_EQ(s.false_alarms, 2U);
  EXPECT_EQ(s.missed, 2U);
  EXPECT_DOUBLE_EQ(s.f1(), 0.5);
  const ClassScores away = scoreClass(found, truth, 14, {0, 0, 0, 0, 0, 1, 1});
  EXPECT_EQ(away.false_alarms, 1U);
  EXPECT_EQ(away.missed, 1U);
  EXPECT_TRUE(std::isnan(scoreClass({}, {}, 14).f1()));
  EXPECT_THROW(scoreClass(found, {14}, 14), std::invalid_argument);
}

TEST(ClassScores, NearnessAgreesWithBruteForce)
{
  const std::uint32_t seed = 20;
  SCOPED_TRACE(seed);
  boost::random::mt19937 engine(seed);
  boost::random::uniform_real_distribution<double> place(-40, 40);
  boost::random::uniform_int_distribution<int> kind(0, 9);
  Points points;
  std::vector<std::uint8_t> classes;
  for (int i = 0; i < 600; ++i) {
    Point p;
    for (int axis = 0; axis < 3; ++axis)
      p[axis] = place(engine);
    points.push_back(p);
    classes.push_back(kind(engine) == 0 ? 15 : 2);
  }
  const auto near = nearClass(points, classes, 15, 6);
  for (std::size_t i = 0; i < points.size(); ++i) {
    bool expected = false;
    for (std::size_t k = 0; k < points.size(); ++k)
      expected = expected ||
                 (classes[k] == 15 && std::hypot(points[k].x() - points[i].x(),
                                                 points[k].y() - points[i].y()) <= 6);
    ASSERT_EQ(near[i] != 0, expected) << i;
  }
}

} // namespace
