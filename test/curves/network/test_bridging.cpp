// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "curves/network/bridging.h"

using namespace linelet;

namespace {

/** \brief A straight curve from x = \a from to x = \a to at height \a y, one edge per
 * half unit. */
ModelCurve
stretch(double from, double to, double y)
{
  ModelCurve curve;
  for (int i = 0; i <= std::lround(2 * (to - from)); ++i)
    curve.nodes.emplace_back(from + 0.5 * i, y, 0);
  return curve;
}

TEST(JunctionBridging, GrowingCurveTakesUpPiecesThatAloneAreTooShort)
{
  // 40 long, then pieces of 8 with gaps of 5: more than 15 % of 8 + 5 + 8 = 21, less
  // than 15 % of 40 + 5 + 8.
  const ModelCurves pieces = {
      stretch(45, 53, 0), stretch(58, 66, 0), stretch(0, 40, 0), stretch(71, 79, 0)};
  const ModelCurves joined = bridgeGaps(pieces, 1, 0, 3);
  ASSERT_EQ(joined.size(), 1u);
  EXPECT_NEAR(length(joined), 79, 1e-9);
  EXPECT_FALSE(joined[0].closed);
  // Without the long piece nothing is joined, nor across gaps beyond the given limit.
  EXPECT_EQ(bridgeGaps({pieces[0], pieces[1], pieces[3]}, 1, 0, 3).size(), 3u);
  EXPECT_EQ(bridgeGaps(pieces, 1, 4, 3).size(), 4u);
}

TEST(JunctionBridging, BridgeExplainsNoPointsThePiecesKeepTheirs)
{
  ModelCurve front = stretch(0, 40, 0), back = stretch(42, 62, 0);
  front.counts.assign(front.edges(), 3);
  back.counts.assign(back.edges(), 5);
  std::reverse(back.nodes.begin(), back.nodes.end());
  const ModelCurves joined = bridgeGaps({back, front}, 1, 0, 3);
  ASSERT_EQ(joined.size(), 1u);
  ASSERT_EQ(joined[0].counts.size(), joined[0].edges());
  for (std::size_t e = 0; e < joined[0].edges(); ++e) {
    const double x = 0.5 * (joined[0].from(e).x() + joined[0].to(e).x());
    EXPECT_EQ(joined[0].counts[e], x < 40 ? 3 : x < 42 ? 0 : 5) << x;
  }
}

TEST(JunctionBridging, NeighborsKeepToTheirOwnSide)
{
  // Two lines 1 apart, with gaps of 4 in the same place.
  const ModelCurves joined = bridgeGaps(
      {stretch(0, 40, 0), stretch(44, 84, 1), stretch(44, 84, 0), stretch(0, 40, 1)},
      0.5,
      0,
      3);
  ASSERT_EQ(joined.size(), 2u);
  for (const ModelCurve& curve : joined)
    for (const Point& p : curve.nodes)
      EXPECT_NEAR(p.y(), curve.nodes[0].y(), 1e-9);
}

TEST(JunctionBridging, EndsAtJunctionsAndClosedCurvesAreLeftAlone)
{
  ModelCurves curves = {stretch(0, 40, 0), stretch(42, 82, 0)};
  curves[0].junction[1] = 0;
  EXPECT_EQ(bridgeGaps(curves, 1, 0, 3).size(), 2u);
  EXPECT_TRUE(bridgeGaps({}, 1, 0, 3).empty());
}

} // namespace
