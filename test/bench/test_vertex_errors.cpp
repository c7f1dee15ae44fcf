// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>

#include <gtest/gtest.h>

#include <bench/measures/vertex_errors.h>

using namespace linelet;
using bench::SegmentTree;
using bench::vertexErrors;

// A straight curve 3 beside the truth, turned by 30 degrees at its end.
TEST(VertexErrors, DistanceAndAngle)
{
  CurveNetwork truth;
  truth.curves.emplace_back().points = {Point(-100, 0, 0), Point(100, 0, 0)};
  Curve curve;
  curve.points = {{0, 3, 0}, {1, 3, 0}, {2, 3, 0}};
  auto errors = vertexErrors(curve, SegmentTree(truth));
  ASSERT_EQ(errors.size(), 3u);
  EXPECT_NEAR(errors[1].distance, 3, 1e-12);
  EXPECT_NEAR(errors[1].angle, 0, 1e-6);
  EXPECT_NEAR(errors[2].along, 2, 1e-12);
  const double c = std::cos(M_PI / 6), s = std::sin(M_PI / 6);
  curve.points = {{0, 0, 0}, {c, s, 0}};
  errors = vertexErrors(curve, SegmentTree(truth));
  EXPECT_NEAR(errors[0].angle, 30, 1e-9);
  EXPECT_NEAR(errors[1].distance, 0.5, 1e-12);
}

TEST(VertexErrors, DegenerateCurves)
{
  CurveNetwork truth;
  EXPECT_TRUE(vertexErrors(Curve(), SegmentTree(truth)).empty());
  Curve point;
  point.points = {{1, 2, 3}};
  EXPECT_TRUE(std::isinf(vertexErrors(point, SegmentTree(truth))[0].distance));
  truth.curves.emplace_back().points = {Point(1, 2, 3), Point(1, 2, 3)};
  EXPECT_EQ(vertexErrors(point, SegmentTree(truth))[0].distance, 0);
  EXPECT_TRUE(std::isnan(vertexErrors(point, SegmentTree(truth))[0].angle));
}
