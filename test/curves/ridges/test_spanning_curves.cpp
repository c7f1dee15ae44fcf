// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_int_distribution.hpp>
#include <gtest/gtest.h>

#include <linelet/curves/refined_reconstruction.h>

#include "curves/ridges/spanning_curves.h"

using namespace linelet;

namespace {

Points
shuffled(Points points)
{
  boost::random::mt19937 random(7);
  for (std::size_t i = points.size(); i > 1; --i) {
    boost::random::uniform_int_distribution<std::size_t> before(0, i - 1);
    std::swap(points[i - 1], points[before(random)]);
  }
  return points;
}

/** \brief A paddle: the outline of a disc of radius 100 and a handle that ends 200 from
 * the middle of the disc. */
struct Paddle {
  Points points;
  double length = 0;

  /** \param[in] width of the handle
   * \param[in] spacing of the points along the handle; it grows to 30 around the disc
   */
  Paddle(double width, double spacing)
  {
    const double begin = std::sqrt(100 * 100 - width * width / 4);
    for (double x = begin; x <= 200; x += spacing)
      for (const double y : {-width / 2, width / 2})
        points.emplace_back(x, y, 0);
    for (double y = spacing - width / 2; y < width / 2 - spacing / 2; y += spacing)
      points.emplace_back(200, y, 0);
    const double handle = std::asin(width / 200), least = spacing / 100;
    double step = least;
    for (double angle = handle + step; angle < 2 * M_PI - handle; angle += step) {
      points.emplace_back(100 * std::cos(angle), 100 * std::sin(angle), 0);
      const double from_handle = std::min(angle, 2 * M_PI - angle) - handle;
      step = std::clamp(0.5 * from_handle, least, 0.3);
    }
    length = 2 * (200 - begin) + width + 100 * (2 * M_PI - 2 * handle);
  }
};

TEST(SpanningCurves, FewPointsAreNotACurve)
{
  EXPECT_TRUE(spanningCurves({}, 6).curves.empty());
  EXPECT_TRUE(spanningCurves({{1, 2, 3}}, 6).curves.empty());
  EXPECT_TRUE(spanningCurves({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, 6).curves.empty());
  EXPECT_TRUE(spanningCurves(Points(20, Point(1, 2, 3)), 30).curves.empty());
}

TEST(SpanningCurves, AnArcWhoseSpacingGrowsIsOneCurveInOrder)
{
  // Each step is a tenth wider than the last, a factor of a hundred in total.
  Points arc;
  double angle = 0.01;
  for (int k = 0; k < 50; ++k, angle *= 1.1)
    arc.emplace_back(std::cos(angle), std::sin(angle), 0);
  const Traces traces = spanningCurves(shuffled(arc), 6);
  ASSERT_EQ(traces.curves.size(), 1u);
  Points nodes = traces.curves[0].nodes;
  if (nodes.front() != arc.front())
    std::reverse(nodes.begin(), nodes.end());
  EXPECT_EQ(nodes, arc);
  EXPECT_TRUE(traces.meetings.empty());
}

TEST(SpanningCurves, ABranchLeavesWhereItMeetsAndTwigsAreLeftOut)
{
  Points tee;
  for (int k = -20; k <= 20; ++k)
    tee.emplace_back(k, 0, 0);
  for (int k = 1; k <= 10; ++k)
    tee.emplace_back(0, 0.9 * k, 0);
  for (int k = 1; k <= 3; ++k)
    tee.emplace_back(10, -0.9 * k, 0);
  const Traces traces = spanningCurves(shuffled(tee), 6);
  ASSERT_EQ(traces.curves.size(), 2u);
  EXPECT_EQ(traces.curves[0].nodes.size(), 41u);
  EXPECT_EQ(traces.curves[1].nodes.size(), 11u);
  ASSERT_EQ(traces.meetings.size(), 1u);
  EXPECT_EQ(traces.meetings[0], Point(0, 0, 0));
}

TEST(SpanningCurves, AnOutlineOfVeryUnevenSpacingIsReconstructedWhole)
{
  // In each of these, ridges alone give the handle or fragments.
  for (const double width : {10.0, 16.0, 24.0})
    for (const double spacing : {2.0, 4.0}) {
      SCOPED_TRACE(testing::Message() << width << " wide, " << spacing << " apart");
      const Paddle paddle(width, spacing);
      const CurveNetwork network = reconstructRefined(shuffled(paddle.points));
      ASSERT_EQ(network.curves.size(), 1u);
      EXPECT_TRUE(network.curves[0].closed);
      EXPECT_NEAR(length(network.curves[0]), paddle.length, 0.03 * paddle.length);
    }
}

} // namespace
