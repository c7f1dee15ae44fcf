// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>

#include <gtest/gtest.h>

#include "curves/network/junctions.h"

using namespace linelet;

namespace {

/** \brief A straight curve from \a from to \a to, with vertices at most 0.1 apart. */
Curve
straight(const Point& from, const Point& to)
{
  Curve curve;
  const auto edges = static_cast<int>(std::ceil((to - from).norm() / 0.1));
  for (int i = 0; i <= edges; ++i)
    curve.points.emplace_back(from + (to - from) * i / edges);
  curve.support.assign(curve.points.size(), 2);
  curve.front.kind = curve.back.kind = EndKind::Support;
  return curve;
}

void
connect(CurveNetwork& network)
{
  const EndReach reach{0.5, 3};
  connectEnds(network,
              std::vector<std::array<EndReach, 2>>(network.curves.size(),
                                                   std::array{reach, reach}));
}

TEST(JunctionNetwork, EndInsideAnotherCurveIsAJunctionOnIt)
{
  // The second stops 0.3 before the first, the third 0.2 after it: both at one place.
  CurveNetwork network{{straight({0, 0, 0}, {10, 0, 0}),
                        straight({4, 5, 0}, {4, 0.3, 0}),
                        straight({4.1, 0.2, 0}, {4.1, -5, 0})},
                       {}};
  connect(network);
  ASSERT_EQ(network.junctions.size(), 1u);
  EXPECT_EQ(network.junctions[0].curves, (std::vector<std::size_t>{0, 1, 2}));
  const Point at = network.junctions[0].position;
  EXPECT_NEAR(at.x(), 4, 0.11);
  EXPECT_NEAR(at.y(), 0, 1e-12);
  EXPECT_EQ(network.curves[1].back.kind, EndKind::Junction);
  EXPECT_EQ(network.curves[1].back.junction, 0);
  EXPECT_EQ(network.curves[1].points.back(), at);
  EXPECT_EQ(network.curves[1].front.kind, EndKind::Support);
  EXPECT_EQ(network.curves[2].front.kind, EndKind::Junction);
  EXPECT_EQ(network.curves[2].points.front(), at);
  EXPECT_EQ(network.curves[0].back.kind, EndKind::Support);
  EXPECT_EQ(length(network.curves[0]), 10);
  // Nothing of the third remains on the far side.
  for (const Point& p : network.curves[2].points)
    EXPECT_LE(p.y(), 1e-12);
  for (const Curve& curve : network.curves)
    EXPECT_EQ(curve.support.size(), curve.points.size());
}

TEST(JunctionNetwork, TheWayToAJunctionHasVerticesLikeTheRest)
{
  // Otherwise, a single edge of 0.45 would lead to the junction, and belong to neither
  // curve by its vertices.
  CurveNetwork network{
      {straight({0, 0, 0}, {10, 0, 0}), straight({4, 5, 0}, {4, 0.45, 0})}, {}};
  connect(network);
  ASSERT_EQ(network.junctions.size(), 1u);
  const Points& points = network.curves[1].points;
  ASSERT_EQ(network.curves[1].support.size(), points.size());
  for (std::size_t k = 1; k < points.size(); ++k)
    EXPECT_LT((points[k] - points[k - 1]).norm(), 0.15) << k;
  EXPECT_NEAR(length(network.curves[1]), 5, 1e-9);
}

TEST(JunctionNetwork, ACurveWithoutLengthEndsTheWork)
{
  Curve spot;
  spot.points.assign(3, Point(4, 0.3, 0));
  CurveNetwork network{{straight({0, 0, 0}, {10, 0, 0}), spot}, {}};
  connect(network);
  EXPECT_LE(network.curves[1].points.size(), 3u);
  for (const Point& p : network.curves[1].points)
    EXPECT_TRUE(p.allFinite());
}

TEST(JunctionNetwork, EndsThatMeetAreOneJunctionAtTheirMiddle)
{
  CurveNetwork network{{straight({5, 0, 0}, {0.1, 0, 0}),
                        straight({0, 0.1, 0}, {0, 5, 0}),
                        straight({0, 0, -5}, {0, 0, -0.1})},
                       {}};
  connect(network);
  ASSERT_EQ(network.junctions.size(), 1u);
  EXPECT_EQ(network.junctions[0].curves.size(), 3u);
  EXPECT_LT((network.junctions[0].position - Point(0.1, 0.1, -0.1) / 3).norm(), 1e-12);
}

TEST(JunctionNetwork, SideBySideIsNotAMeeting)
{
  CurveNetwork network{{straight({0, 0, 0}, {10, 0, 0}),
                        straight({0, 0.3, 0}, {10, 0.3, 0}),
                        straight({3, 0, 0.3}, {7, 0, 0.3})},
                       {}};
  connect(network);
  EXPECT_TRUE(network.junctions.empty());
  for (const Curve& curve : network.curves)
    EXPECT_EQ(curve.front.kind, EndKind::Support);
}

TEST(JunctionNetwork, OwnEndsCloseACurveAndOneOnItsOwnInsideIsAJunction)
{
  Curve ring;
  for (int i = 0; i <= 98; ++i) // almost a full turn
    ring.points.emplace_back(
        2 * std::cos(2 * M_PI * i / 100), 2 * std::sin(2 * M_PI * i / 100), 0);
  // A six: a stem whose loop returns to itself.
  Curve six = straight({10, 10, 0}, {10, 2, 0});
  for (int i = 1; i <= 95; ++i)
    six.points.emplace_back(10 - 2 + 2 * std::cos(2 * M_PI * i / 100),
                            2 - 2 * std::sin(2 * M_PI * i / 100),
                            0);
  six.points.emplace_back(9.8, 3, 0);
  six.support.clear();
  CurveNetwork network{{ring, six}, {}};
  connect(network);
  EXPECT_TRUE(network.curves[0].closed);
  EXPECT_EQ(network.curves[0].front.kind, EndKind::Loop);
  EXPECT_FALSE(network.curves[1].closed);
  ASSERT_EQ(network.junctions.size(), 1u);
  EXPECT_EQ(network.junctions[0].curves, (std::vector<std::size_t>{1}));
  EXPECT_EQ(network.curves[1].back.kind, EndKind::Junction);
  EXPECT_EQ(network.curves[1].front.kind, EndKind::Support);
}

TEST(JunctionNetwork, NothingAndTheSmallestCurves)
{
  CurveNetwork empty;
  connect(empty);
  EXPECT_TRUE(empty.junctions.empty());
  CurveNetwork small{
      {straight({0, 0, 0}, {0.05, 0, 0}), straight({0, 0, 0}, {0, 1, 0})}, {}};
  connect(small);
  ASSERT_EQ(small.junctions.size(), 1u);
  for (const Curve& curve : small.curves) {
    EXPECT_GE(curve.points.size(), 2u);
    for (const Point& p : curve.points)
      EXPECT_TRUE(p.allFinite());
  }
}

} // namespace
