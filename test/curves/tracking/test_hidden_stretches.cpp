// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "curves/tracking/hidden_stretches.h"

using namespace linelet;

namespace {

constexpr double widest = 150; // spacings

/** \brief Height of a wire that hangs from \a x = 0 to 100 m, in meters. */
double
sag(double x)
{
  constexpr double a = 400; // catenary constant
  return a * std::cosh((x - 50) / a) - a;
}

/** \brief Such a wire at \a y, seen from \a from to \a to: a node every 4 m, from two
 * points per meter within 3 cm. */
ModelCurve
piece(double from, double to, double y = 0)
{
  ModelCurve curve;
  const auto edges = static_cast<int>(std::ceil((to - from) / 4));
  for (int k = 0; k <= edges; ++k) {
    const double x = from + (to - from) * k / edges;
    curve.nodes.emplace_back(x, y + (k % 2 == 0 ? 0.01 : -0.01), sag(x));
  }
  curve.counts.assign(curve.edges(), 2 * (to - from) / edges);
  curve.noise = 0.03;
  curve.evidence = 100;
  return curve;
}

TEST(HiddenStretches, NothingToJoinStaysAsItIs)
{
  EXPECT_TRUE(joinHiddenStretches({}, widest).empty());
  ModelCurve edge;
  edge.nodes = {Point(0, 0, 0), Point(4, 0, 0)};
  edge.counts = {8};
  ModelCurve next = edge;
  for (Point& node : next.nodes)
    node.x() += 5;
  // Two nodes do not make a parabola; points in one place have no direction.
  ModelCurve place = edge;
  place.nodes.assign(5, Point(4.5, 0, 0));
  place.counts.assign(4, 0);
  EXPECT_EQ(joinHiddenStretches({edge, place, next}, widest).size(), 3u);
  const ModelCurves one = joinHiddenStretches({piece(0, 40)}, widest);
  ASSERT_EQ(one.size(), 1u);
  EXPECT_EQ(one[0].nodes.size(), piece(0, 40).nodes.size());
}

TEST(HiddenStretches, WireBehindACrownIsOne)
{
  ModelCurve behind = piece(60, 100);
  std::reverse(behind.nodes.begin(), behind.nodes.end());
  const ModelCurves joined = joinHiddenStretches({behind, piece(0, 35)}, widest);
  ASSERT_EQ(joined.size(), 1u);
  ASSERT_EQ(joined[0].counts.size(), joined[0].edges());
  for (std::size_t e = 0; e < joined[0].edges(); ++e) {
    const Point middle = 0.5 * (joined[0].from(e) + joined[0].to(e));
    EXPECT_NEAR(middle.y(), 0, 0.02) << middle.x();
    EXPECT_NEAR(middle.z(), sag(middle.x()), 0.04) << middle.x();
    EXPECT_EQ(joined[0].counts[e] > 0, middle.x() < 35 || middle.x() > 60);
  }
  EXPECT_NEAR(std::accumulate(joined[0].counts.begin(), joined[0].counts.end(), 0.0),
              2 * 75,
              1e-9);
  EXPECT_EQ(joined[0].evidence, 200);
}

TEST(HiddenStretches, ManyGapsAreClosedOneAfterTheOther)
{
  // The short pieces span the wide gap only once they are one.
  const ModelCurves joined = joinHiddenStretches(
      {piece(0, 12), piece(16, 28), piece(50, 62), piece(66, 78)}, widest);
  EXPECT_EQ(joined.size(), 1u);
  EXPECT_EQ(joinHiddenStretches({piece(16, 28), piece(50, 62)}, widest).size(), 2u);
  EXPECT_EQ(joinHiddenStretches({piece(0, 35), piece(60, 100)}, 20).size(), 2u);
  EXPECT_EQ(joinHiddenStretches({piece(0, 35), piece(60, 100)}, widest, 24).size(), 2u);
  EXPECT_EQ(joinHiddenStretches({piece(0, 35), piece(60, 100)}, widest, 26).size(), 1u);
}

TEST(HiddenStretches, WiresSideBySideKeepApart)
{
  EXPECT_EQ(joinHiddenStretches({piece(0, 35), piece(60, 100, 0.35)}, widest).size(),
            2u);
  const ModelCurves two = joinHiddenStretches(
      {piece(0, 35), piece(60, 100, 0.35), piece(60, 100), piece(0, 35, 0.35)}, widest);
  ASSERT_EQ(two.size(), 2u);
  for (const ModelCurve& curve : two)
    for (const Point& node : curve.nodes)
      EXPECT_NEAR(node.y(), curve.nodes.front().y(), 0.05);
}

TEST(HiddenStretches, SpansAreNotJoinedPastTheirPole)
{
  // The pole stands in the gap, and the next span starts there.
  ModelCurve next = piece(10, 50);
  for (Point& node : next.nodes)
    node.x() += 100;
  EXPECT_EQ(joinHiddenStretches({piece(50, 90), next}, widest).size(), 2u);
}

} // namespace
