// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// A scene larger than a block gives the same curves whatever else of it is loaded, and
// wires through many blocks are one curve each.

#include <linelet/curves/curve_blocks.h>

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include <linelet/curves/reconstruct_curves.h>
#include <linelet/curves/refined_reconstruction.h>

#include "random_seed.h"

namespace linelet::test {
namespace {

constexpr double side = 1200, width = 20;

/** Ground, and two wires across all of it. */
Points
scene(std::mt19937& random)
{
  std::uniform_real_distribution<double> unit(0, 1);
  std::normal_distribution<double> noise(0, 0.03);
  Points points;
  for (int k = 0; k < 24000; ++k)
    points.emplace_back(side * unit(random), width * unit(random), noise(random));
  for (const double y : {7.0, 13.0})
    for (int k = 0; k < 3600; ++k) {
      const double x = side * unit(random);
      points.emplace_back(
          x, y + noise(random), 12 + 3 * std::sin(x / 80) + noise(random));
    }
  std::shuffle(points.begin(), points.end(), random);
  return points;
}

void
expectSame(const CurvePart& one, const CurvePart& other)
{
  ASSERT_EQ(one.pieces.size(), other.pieces.size());
  for (std::size_t k = 0; k < one.pieces.size(); ++k) {
    const Curve &a = one.pieces[k].curve, &b = other.pieces[k].curve;
    EXPECT_TRUE(a.points == b.points) << k;
    EXPECT_EQ(a.support, b.support) << k;
    EXPECT_EQ(a.evidence, b.evidence) << k;
    for (const std::size_t end : {0, 1})
      EXPECT_TRUE(one.pieces[k].cuts[end].beyond == other.pieces[k].cuts[end].beyond);
  }
}

// Every place has one owner, and everything a block needs is within its margin.
TEST(CurveBlocks, TileThePlane)
{
  std::mt19937 random(randomSeed());
  std::uniform_real_distribution<double> extent(1, 3000), unit(-0.2, 1.2);
  for (int round = 0; round < 20; ++round) {
    CloudTraits whole{1, 0.1, 1e6, Point(-50, 20, 0), Point()};
    whole.high = whole.low + Point(extent(random), extent(random), 10);
    const CurveBlocks blocks(whole);
    for (std::size_t b = 0; b < blocks.count(); ++b)
      EXPECT_EQ(blocks.owner(blocks.middle(b)), b);
    for (int k = 0; k < 200; ++k) {
      const Point span = whole.high - whole.low;
      const Point p = whole.low + Point(unit(random) * span.x(),
                                        unit(random) * span.y(),
                                        unit(random) * span.z());
      ASSERT_LT(blocks.owner(p), blocks.count());
      for (std::size_t b = 0; blocks.count() > 1 && b < blocks.count(); ++b)
        if (blocks.takesPart(p, b)) {
          EXPECT_LE((p - blocks.middle(b)).head<2>().cwiseAbs().maxCoeff(),
                    blocks.reach());
        }
    }
  }
}

TEST(CurveBlocks, AreOneOfWhatHasNoBorders)
{
  const Point low = Point::Zero(), high(1e5, 1e5, 10);
  EXPECT_GT(CurveBlocks({1, 0.1, 1e6, low, high}).count(), 1U);
  EXPECT_EQ(CurveBlocks({1, 0.1, 1000, low, high}).count(), 1U) << "a small cloud";
  EXPECT_EQ(CurveBlocks({1, 0.95, 1e6, low, high}).count(), 1U) << "curves alone";
  EXPECT_EQ(CurveBlocks({NAN, 0, 1, low, low}).count(), 1U) << "one point";
  EXPECT_EQ(CurveBlocks({}).count(), 1U);
}

TEST(CurveBlocks, DependOnThePointsWithinReachAlone)
{
  std::mt19937 random(randomSeed());
  const Points points = scene(random);
  RefinedSettings settings;
  settings.whole = cloudTraits(points);
  const CurveBlocks blocks(settings.whole);
  ASSERT_GT(blocks.count(), 2U);
  std::size_t pieces = 0;
  for (std::size_t b = 0; b < blocks.count(); ++b) {
    Points near;
    for (const Point& p : points)
      if ((p - blocks.middle(b)).head<2>().cwiseAbs().maxCoeff() <= blocks.reach())
        near.push_back(p);
    ASSERT_LT(near.size(), points.size());
    const CurvePart part = curvesOfBlock(near, b, settings);
    expectSame(part, curvesOfBlock(points, b, settings));
    pieces += part.pieces.size();
  }
  EXPECT_GE(pieces, 2 * blocks.count());
}

TEST(CurveBlocks, WiresThroughManyAreOneCurveEach)
{
  std::mt19937 random(randomSeed());
  const CurveNetwork network = reconstructCurves(scene(random));
  ASSERT_EQ(network.curves.size(), 2U);
  for (const Curve& curve : network.curves) {
    double along = 0;
    for (std::size_t k = 1; k < curve.points.size(); ++k) {
      const Point edge = curve.points[k] - curve.points[k - 1];
      EXPECT_LT(edge.norm(), 5) << "through empty space";
      along += std::abs(edge.x());
    }
    EXPECT_NEAR(along, side, 0.01 * side);
  }
}

} // namespace
} // namespace linelet::test
