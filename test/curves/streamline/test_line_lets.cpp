// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>

#include <gtest/gtest.h>

#include "curves/streamline/cloud_neighbors.h"
#include "curves/streamline/joining.h"
#include "curves/streamline/line_lets.h"
#include "curves/streamline/meeting.h"
#include "curves/streamline/pruning.h"

using namespace linelet;

namespace {

/** \brief A line-let from \a from to \a to in steps of 1, grown at its front. */
Index
straight(LineLets& lets, const Point& from, const Point& to)
{
  const Point step = (to - from).normalized();
  const Index line = lets.start(from, step);
  const int steps = static_cast<int>(std::lround((to - from).norm()));
  for (int i = 1; i <= steps; ++i)
    lets.append(line, front_side, from + i * step);
  lets.lines[line].ends[front_side].direction = step;
  return line;
}

} // namespace

TEST(SkewLines, ClosestPointsByHand)
{
  // The x axis, and a line along y at height 3 through x = 2.
  const SkewLines found =
      closestOnSkewLines({0, 0, 0}, {1, 0, 0}, {2, -5, 3}, {0, 2, 0});
  EXPECT_FALSE(found.parallel);
  EXPECT_NEAR(found.on_first, 2, 1e-12);
  EXPECT_NEAR(found.on_second, 2.5, 1e-12);
  EXPECT_TRUE(closestOnSkewLines({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-3, 0, 0}).parallel);
}

TEST(Meeting, OpenEndsMeetAtTheirMean)
{
  LineLets lets(1.4);
  const Index a = straight(lets, {-10, 0, 0}, {0, 0, 0});
  const Index b = straight(lets, {11, 0.5, 0}, {1, 0.5, 0});
  ASSERT_TRUE(meet(lets, a, front_side, 1.4));
  EXPECT_TRUE(lets.lines[a].ends[front_side].closed);
  EXPECT_TRUE(lets.lines[b].ends[front_side].closed);
  const CurveNetwork network = join(lets, 0);
  ASSERT_EQ(network.curves.size(), 1u) << "two line-lets make one curve";
  EXPECT_TRUE(network.junctions.empty());
  double nearest = 1;
  for (const Point& p : network.curves[0].points)
    nearest = std::min(nearest, (p - Point(0.5, 0.25, 0)).norm());
  EXPECT_LT(nearest, 1e-12);
}

TEST(Meeting, AnEndCrossesASegmentWhereTheSkewLinesAreClosest)
{
  LineLets lets(1.4);
  straight(lets, {-10, 0, 0.4}, {10, 0, 0.4});
  const Index b = straight(lets, {0.3, -10, 0}, {0.3, -1, 0});
  ASSERT_TRUE(meet(lets, b, front_side, 1.4));
  const CurveNetwork network = join(lets, 0);
  ASSERT_EQ(network.junctions.size(), 1u);
  EXPECT_LT((network.junctions[0].position - Point(0.3, 0, 0.4)).norm(), 1e-12);
  ASSERT_EQ(network.curves.size(), 3u);
  EXPECT_EQ(network.junctions[0].curves, (std::vector<std::size_t>{0, 1, 2}));
  for (const Curve& curve : network.curves) {
    const int joined = (curve.front.kind == EndKind::Junction ? 1 : 0) +
                       (curve.back.kind == EndKind::Junction ? 1 : 0);
    EXPECT_EQ(joined, 1);
  }
}

TEST(Meeting, TheFarAndTheOwnRecentPathAreNotEncounters)
{
  LineLets lets(1.4);
  const Index a = straight(lets, {0, 0, 0}, {10, 0, 0});
  straight(lets, {0, 3, 0}, {10, 3, 0});
  EXPECT_FALSE(meet(lets, a, front_side, 1.4));
  EXPECT_FALSE(lets.lines[a].ends[front_side].closed);
}

TEST(Meeting, ALineLetClosesOnItsOwnOtherEnd)
{
  LineLets lets(1.4);
  const int sides = 24;
  const auto corner = [&](int i) {
    const double angle = 2 * M_PI * i / sides, radius = sides / (2 * M_PI);
    return Point(radius * std::cos(angle), radius * std::sin(angle), 0);
  };
  const Index line = lets.start(corner(0), {0, 1, 0});
  for (int i = 1; i < sides; ++i)
    lets.append(line, front_side, corner(i));
  ASSERT_TRUE(meet(lets, line, front_side, 1.4));
  const CurveNetwork network = join(lets, 0);
  ASSERT_EQ(network.curves.size(), 1u);
  EXPECT_TRUE(network.curves[0].closed);
  EXPECT_EQ(network.curves[0].front.kind, EndKind::Loop);
  EXPECT_EQ(network.curves[0].points.size(), static_cast<std::size_t>(sides - 1))
      << "the two ends have become one vertex";
}

TEST(Joining, ABranchAndItsOriginAreOneCurveWithACorner)
{
  LineLets lets(1.4);
  const Index a = straight(lets, {0, 0, 0}, {5, 0, 0});
  lets.lines[a].ends[front_side].closed = true;
  const Index b = lets.branch(lets.lines[a].ends[front_side].vertex, {0, 1, 0});
  for (int i = 1; i <= 5; ++i)
    lets.append(b, front_side, Point(5, i, 0));
  EXPECT_EQ(lets.stepsBetween(b, front_side, 4), 6)
      << "five steps along the branch, one back along the origin";
  const CurveNetwork network = join(lets, 0);
  ASSERT_EQ(network.curves.size(), 1u);
  EXPECT_NEAR(length(network), 10, 1e-12);
}

TEST(Joining, StumpsGoAndWhatTheyCutStaysOneCurve)
{
  LineLets lets(1.4);
  straight(lets, {-10, 0, 0}, {10, 0, 0});
  const Index stump = straight(lets, {0, -2, 0}, {0, -1, 0});
  ASSERT_TRUE(meet(lets, stump, front_side, 1.4));
  EXPECT_EQ(join(lets, 0).curves.size(), 3u);
  const CurveNetwork network = join(lets, 4);
  ASSERT_EQ(network.curves.size(), 1u);
  EXPECT_NEAR(length(network), 20, 1e-12);
  EXPECT_TRUE(network.junctions.empty());
}

TEST(Pruning, OpenEndsAreCutBackToThePoints)
{
  LineLets lets(1.4);
  const Index line = straight(lets, {0, 0, 0}, {10, 0, 0});
  lets.lines[line].ends[front_side].kind = EndKind::Cutoff;
  const Points points = {{0, 0, 0}, {3, 0, 0}, {6, 0, 0}};
  pruneOpenEnds(lets, CloudNeighbors(points, 1), 1.2);
  const CurveNetwork network = join(lets, 0);
  ASSERT_EQ(network.curves.size(), 1u);
  EXPECT_NEAR(length(network), 7, 1e-12) << "x = 7 is the last within 1.2 of a point";
  EXPECT_EQ(network.curves[0].back.kind, EndKind::Cutoff);
}

TEST(Pruning, ClosedEndsAndJoinedVerticesStay)
{
  LineLets lets(1.4);
  straight(lets, {-10, 0, 0}, {10, 0, 0});
  const Index b = straight(lets, {0, -10, 0}, {0, -1, 0});
  ASSERT_TRUE(meet(lets, b, front_side, 1.4));
  // Points on the arm only: the other line-let is cut back to where the arm meets it.
  Points points;
  for (int i = 0; i <= 10; ++i)
    points.emplace_back(0, -i, 0);
  pruneOpenEnds(lets, CloudNeighbors(points, 1), 0.5);
  EXPECT_NEAR(length(join(lets, 0)), 10, 1e-12);
}

TEST(Pruning, ALineLetFarFromAllPointsVanishes)
{
  LineLets lets(1.4);
  straight(lets, {0, 0, 0}, {10, 0, 0});
  const Points points = {{50, 0, 0}};
  pruneOpenEnds(lets, CloudNeighbors(points, 1), 1);
  EXPECT_TRUE(join(lets, 0).curves.empty());
}
