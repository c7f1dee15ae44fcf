// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// Curves cut at the borders of parts and joined again are the original curves.

#include <linelet/curves/curve_parts.h>

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "random_seed.h"

namespace linelet::test {
namespace {

constexpr std::size_t rows = 64; // of boxes

/** Square boxes, each its own part. */
PartOwner
boxes(double x, double y, double side)
{
  return [=](const Point& p) {
    const auto number = [&](double value) {
      return static_cast<std::size_t>(
          std::clamp(std::floor(value / side) + rows / 2, 0.0, rows - 1.0));
    };
    return number(p.x() - x) * rows + number(p.y() - y);
  };
}

/** A wandering curve with one point per vertex. */
Curve
wandering(std::mt19937& random, std::size_t vertices)
{
  std::normal_distribution<double> turn(0, 0.1);
  std::uniform_real_distribution<double> place(-20, 20);
  Curve curve;
  Point at(place(random), place(random), place(random));
  double angle = place(random);
  for (std::size_t k = 0; k < vertices; ++k) {
    curve.points.push_back(at);
    angle += turn(random);
    at += 0.3 * Point(std::cos(angle), std::sin(angle), turn(random));
  }
  curve.support.assign(vertices, 1);
  curve.front.kind = curve.back.kind = EndKind::Support;
  curve.noise = 0.01;
  curve.density = 3;
  curve.evidence = 100;
  return curve;
}

Curve
ring(double radius)
{
  Curve curve = Curve();
  for (int k = 0; k < 200; ++k)
    curve.points.emplace_back(
        radius * std::cos(k * M_PI / 100), radius * std::sin(k * M_PI / 100), 1);
  curve.support.assign(200, 1);
  curve.closed = true;
  curve.front.kind = curve.back.kind = EndKind::Loop;
  curve.noise = 0.01;
  curve.density = 3;
  curve.evidence = 50;
  return curve;
}

std::vector<CurvePart>
partsOf(const CurveNetwork& network, const PartOwner& owner, double reach)
{
  std::vector<CurvePart> parts;
  for (std::size_t f = 0; f < rows * rows; ++f)
    parts.push_back(ownedBy(network, f, owner, reach));
  return parts;
}

std::size_t
supportOf(const Curve& curve)
{
  std::size_t sum = 0;
  for (const Index count : curve.support)
    sum += count;
  return sum;
}

/** The curve of \a network that has \a vertex. */
const Curve*
curveWith(const CurveNetwork& network, const Point& vertex)
{
  for (const Curve& curve : network.curves)
    if (std::find(curve.points.begin(), curve.points.end(), vertex) !=
        curve.points.end())
      return &curve;
  return nullptr;
}

void
expectSame(const CurveNetwork& joined, const CurveNetwork& whole)
{
  ASSERT_EQ(joined.curves.size(), whole.curves.size());
  for (const Curve& curve : whole.curves) {
    const Curve* same = curveWith(joined, curve.points[1]);
    ASSERT_NE(same, nullptr);
    EXPECT_EQ(same->closed, curve.closed);
    EXPECT_NEAR(length(*same), length(curve), 1e-9);
    EXPECT_NEAR(same->noise, curve.noise, 1e-9);
    EXPECT_NEAR(same->density, curve.density, 1e-9);
    EXPECT_NEAR(same->evidence, curve.evidence, 1e-9);
    EXPECT_EQ(supportOf(*same), supportOf(curve));
    EXPECT_EQ(same->points.size(), same->support.size());
    for (const Point& vertex : curve.points)
      EXPECT_EQ(curveWith(joined, vertex), same) << vertex.transpose();
  }
}

TEST(CurveParts, JoinedAreTheCurvesThatWereCut)
{
  std::mt19937 random(randomSeed());
  for (int i = 0; i < 5; ++i) {
    CurveNetwork whole;
    for (int c = 0; c < 6; ++c)
      whole.curves.push_back(wandering(random, 150));
    whole.curves.push_back(ring(9));
    std::uniform_real_distribution<double> side(4, 40), origin(0, 10);
    const PartOwner owner = boxes(origin(random), origin(random), side(random));
    expectSame(joinParts(partsOf(whole, owner, 2), 1e-3), whole);
  }
}

// Two wires closer than the tolerance are not swapped.
TEST(CurveParts, TheClosestAreJoined)
{
  CurveNetwork whole;
  for (const double y : {0.0, 0.1}) {
    whole.curves.push_back(ring(9));
    Curve& curve = whole.curves.back();
    curve.closed = false;
    curve.points.clear();
    for (int k = 0; k < 200; ++k)
      curve.points.emplace_back(0.1 * k, y, 5);
  }
  expectSame(joinParts(partsOf(whole, boxes(0.05, -20, 3.3), 2), 0.5), whole);
}

// A curve that a neighbor sees slightly differently is still one, with the border
// vertex halfway.
TEST(CurveParts, SlightlyDifferentCoursesAreJoined)
{
  const PartOwner owner = boxes(0, -20, 100);
  std::vector<CurvePart> parts;
  for (const double y : {0.0, 0.02}) {
    CurveNetwork found;
    found.curves.emplace_back();
    for (int k = -20; k < 20; ++k)
      found.curves.back().points.emplace_back(0.5 * k + 0.1, y, 5);
    const std::size_t self = owner({y > 0 ? 1.0 : -1.0, 0, 0});
    parts.resize(std::max(parts.size(), self + 1));
    parts[self] = ownedBy(found, self, owner, 2);
  }
  EXPECT_EQ(joinParts(parts, 0.01).curves.size(), 2U);
  const CurveNetwork joined = joinParts(parts, 0.05);
  ASSERT_EQ(joined.curves.size(), 1U);
  const Points& points = joined.curves[0].points;
  EXPECT_TRUE(std::any_of(points.begin(), points.end(), [](const Point& p) {
    return (p - Point(0, 0.01, 5)).norm() < 1e-9;
  }));
}

// The neighbor has it only up to the border.
TEST(CurveParts, AnEndShortOfTheBorderIsReached)
{
  const PartOwner owner = boxes(0, -20, 100);
  const auto line = [](double from, double to) {
    CurveNetwork found;
    found.curves.emplace_back();
    for (double x = from; x < to + 0.25; x += 0.5)
      found.curves.back().points.emplace_back(x, 0, 5);
    return found;
  };
  const std::size_t left = owner({-1, 0, 0}), right = owner({1, 0, 0});
  std::vector<CurvePart> parts(std::max(left, right) + 1);
  parts[left] = ownedBy(line(-10, 3), left, owner, 5);
  parts[right] = ownedBy(line(1, 10), right, owner, 5);
  const CurveNetwork joined = joinParts(parts, 0.4);
  ASSERT_EQ(joined.curves.size(), 1U);
  EXPECT_NEAR(length(joined), 20, 1e-9);
}

// The neighbor has only a curve that ends elsewhere.
TEST(CurveParts, AnEndFarFromTheCutIsLeftAlone)
{
  const PartOwner owner = boxes(0, -20, 100);
  const auto line = [](double from, double to, double y) {
    CurveNetwork found;
    found.curves.emplace_back();
    for (double x = from; x < to + 0.25; x += 0.5)
      found.curves.back().points.emplace_back(x, y, 5);
    return found;
  };
  const std::size_t left = owner({-1, 0, 0}), right = owner({1, 0, 0});
  for (const auto& [from, y] : {std::pair(40.0, 0.0), {5.0, 0.0}, {1.0, 0.5}}) {
    std::vector<CurvePart> parts(std::max(left, right) + 1);
    parts[left] = ownedBy(line(-10, 3, 0), left, owner, 5);
    parts[right] = ownedBy(line(from, 60, y), right, owner, 5);
    const CurveNetwork joined = joinParts(parts, 0.4);
    ASSERT_EQ(joined.curves.size(), 2U) << from << ", " << y;
    EXPECT_NEAR(length(joined), 10 + 60 - from, 1e-9);
  }
}

// Where a curve runs almost along the border, both neighbors may leave it out, or both
// may have it.
TEST(CurveParts, AlongABorderNothingIsLostOrTwice)
{
  const PartOwner owner = boxes(0, -20, 100);
  for (const double slope : {0.1, 0.02, -0.02, -0.1})
    for (const double apart : {0.03, -0.03}) {
      CurveNetwork found;
      found.curves.emplace_back();
      for (double y = -9.9; y < 10; y += 0.3)
        found.curves.back().points.emplace_back(slope * y, y, 5);
      std::vector<CurvePart> parts;
      for (const double side : {-1.0, 1.0}) {
        CurveNetwork seen = found;
        for (Point& p : seen.curves[0].points)
          p.x() += side * apart / 2;
        const std::size_t self = owner({side, 0, 0});
        parts.resize(std::max(parts.size(), self + 1));
        parts[self] = ownedBy(seen, self, owner, 5);
      }
      const CurveNetwork joined = joinParts(parts, 0.1);
      ASSERT_EQ(joined.curves.size(), 1U) << slope << ", " << apart;
      EXPECT_NEAR(length(joined), length(found), 0.01) << slope << ", " << apart;
      for (std::size_t k = 1; k < joined.curves[0].points.size(); ++k)
        EXPECT_LT((joined.curves[0].points[k] - joined.curves[0].points[k - 1]).norm(),
                  0.35);
    }
}

TEST(CurveParts, JunctionsKeepTheirCurves)
{
  CurveNetwork whole;
  whole.curves.resize(2);
  for (int k = -20; k <= 20; ++k)
    whole.curves[0].points.emplace_back(0.5 * k, 1, 0);
  for (int k = 0; k <= 20; ++k)
    whole.curves[1].points.emplace_back(2, 1 + 0.5 * k, 0);
  whole.curves[1].front = {EndKind::Junction, 0};
  whole.junctions.push_back({Point(2, 1, 0), {0, 1}});
  const CurveNetwork joined = joinParts(partsOf(whole, boxes(0.3, 0.2, 3), 2), 1e-3);
  ASSERT_EQ(joined.curves.size(), 2U);
  ASSERT_EQ(joined.junctions.size(), 1U);
  EXPECT_EQ(joined.junctions[0].curves, (std::vector<std::size_t>{0, 1}));
  const Curve* branch = curveWith(joined, Point(2, 6, 0));
  ASSERT_NE(branch, nullptr);
  EXPECT_EQ(branch->front.kind, EndKind::Junction);
  EXPECT_EQ(branch->front.junction, 0);
}

TEST(CurveParts, Nothing)
{
  EXPECT_TRUE(joinParts({}, 1).curves.empty());
  EXPECT_TRUE(joinParts({CurvePart(), CurvePart()}, 1).curves.empty());
}

} // namespace
} // namespace linelet::test
