// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <limits>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_01.hpp>
#include <gtest/gtest.h>

#include <bench/geometries/geometries.h>
#include <bench/measures/measures.h>
#include <bench/measures/segment_tree.h>

using linelet::Curve;
using linelet::CurveNetwork;
using linelet::Point;
using linelet::Points;
using linelet::bench::Geometry;
using linelet::bench::measure;
using linelet::bench::Measures;
using linelet::bench::SegmentTree;
using linelet::bench::truthOf;

namespace {

Curve
polyline(Points vertices, bool closed = false)
{
  Curve curve;
  curve.points = std::move(vertices);
  curve.closed = closed;
  return curve;
}

Curve
circle(double radius, std::size_t vertices, double turn = 0)
{
  Points points;
  for (std::size_t i = 0; i < vertices; ++i) {
    const double angle =
        turn + 2 * M_PI * static_cast<double>(i) / static_cast<double>(vertices);
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0);
  }
  return polyline(points, true);
}

const CurveNetwork line10{{polyline({{0, 0, 0}, {10, 0, 0}})}, {}};

} // namespace

TEST(Measures, EveryGeometryMatchesItself)
{
  for (const auto& entry : linelet::Names<Geometry>::table) {
    const CurveNetwork truth = truthOf(entry.first);
    const Measures m = measure(truth, truth);
    EXPECT_NEAR(m.e_h, 0, 1e-12) << entry.second;
    EXPECT_NEAR(m.e_v, 0, 1e-12) << entry.second;
    EXPECT_NEAR(m.e_len, 1, 1e-12) << entry.second;
    EXPECT_NEAR(m.e_com, 1, 1e-9) << entry.second;
    EXPECT_TRUE(m.success) << entry.second;
  }
}

TEST(Measures, ShiftedLineIsOffByItsShift)
{
  for (const double shift : {0.2, 0.3}) {
    const Measures m = measure(
        {{polyline({{0, shift, 0}, {4, shift, 0}, {10, shift, 0}})}, {}}, line10);
    EXPECT_NEAR(m.e_h, shift, 1e-12);
    EXPECT_NEAR(m.e_v, shift, 1e-12);
    EXPECT_NEAR(m.e_len, 1, 1e-12);
    EXPECT_NEAR(m.e_com, 1, 1e-12);
    EXPECT_EQ(m.success, shift <= 0.25);
  }
}

TEST(Measures, LargerCircleIsOffByTheDifferenceOfRadii)
{
  const Measures m = measure({{circle(5.2, 800, 0.003)}, {}}, {{circle(5, 800)}, {}});
  EXPECT_NEAR(m.e_h, 0.2, 1e-3);
  EXPECT_NEAR(m.e_v, 0.2, 1e-3);
  EXPECT_NEAR(m.e_len, 1.04, 1e-9);
  EXPECT_NEAR(m.e_com, 1, 1e-9);
  EXPECT_TRUE(m.success);
}

TEST(Measures, HalfOfALine)
{
  const Measures m = measure({{polyline({{0, 0, 0}, {5, 0, 0}})}, {}}, line10);
  EXPECT_NEAR(m.e_h, 5, 1e-12);
  // 201 samples of the truth, 100 of them with distances 0.05 ... 5; 101 of the half.
  EXPECT_NEAR(m.e_v, 0.05 * 100 * 101 / 2 / (201 + 101), 1e-9);
  EXPECT_NEAR(m.e_len, 0.5, 1e-12);
  EXPECT_NEAR(m.e_com, 0.5, 1e-12);
  EXPECT_FALSE(m.success);
}

TEST(Measures, DoubledCurveIsTwiceAsLongButCoversOnce)
{
  const CurveNetwork truth{{circle(5, 400)}, {}};
  const Measures m = measure({{circle(5, 400), circle(5, 300, 1)}, {}}, truth);
  EXPECT_NEAR(m.e_len, 2, 1e-3);
  EXPECT_NEAR(m.e_com, 1, 1e-6);
  EXPECT_FALSE(m.success);
}

TEST(Measures, ClosedTruthIsCoveredTheShortWayRound)
{
  // From 340 to 20 degrees, through the start of the circle's arc.
  const double d = M_PI / 180;
  const CurveNetwork truth{{circle(5, 720)}, {}};
  const CurveNetwork part{{polyline({{5 * std::cos(-20 * d), 5 * std::sin(-20 * d), 0},
                                     {5 * std::cos(20 * d), 5 * std::sin(20 * d), 0}})},
                          {}};
  EXPECT_NEAR(measure(part, truth).e_com, 40.0 / 360, 1e-9);
}

TEST(Measures, OnlyEdgesNearOneCurveOfTheTruthCover)
{
  const CurveNetwork truth{
      {polyline({{0, 0, 0}, {10, 0, 0}}), polyline({{0, 2, 0}, {10, 2, 0}})}, {}};
  // 0.6 away: too far. Just within 0.5: counted.
  EXPECT_EQ(measure({{polyline({{0, -0.6, 0}, {10, -0.6, 0}})}, {}}, truth).e_com, 0);
  EXPECT_NEAR(measure({{polyline({{0, -0.499, 0}, {10, -0.499, 0}})}, {}}, truth).e_com,
              0.5,
              1e-9);
  // A single vertex on either curve covers nothing.
  EXPECT_EQ(measure({{polyline({{0, 0, 0}, {10, 2, 0}})}, {}}, truth).e_com, 0);
}

TEST(Measures, NothingReconstructed)
{
  for (const CurveNetwork& none : {CurveNetwork{}, CurveNetwork{{Curve{}}, {}}}) {
    const Measures m = measure(none, line10);
    EXPECT_TRUE(std::isnan(m.e_h));
    EXPECT_TRUE(std::isnan(m.e_v));
    EXPECT_EQ(m.e_len, 0);
    EXPECT_EQ(m.e_com, 0);
    EXPECT_FALSE(m.success);
  }
}

TEST(Measures, SingleVertexIsAPlaceWithoutLength)
{
  const Measures m = measure({{polyline({{5, 3, 0}})}, {}}, line10);
  EXPECT_NEAR(m.e_h, std::hypot(5, 3), 1e-12);
  EXPECT_EQ(m.e_len, 0);
  EXPECT_EQ(m.e_com, 0);
}

TEST(Measures, RefusesUnmeasurableCurves)
{
  EXPECT_THROW(measure(line10, {}), std::invalid_argument);
  EXPECT_THROW(measure(line10, {{polyline({{1, 1, 1}})}, {}}), std::invalid_argument);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(measure({{polyline({{0, 0, 0}, {1, nan, 0}})}, {}}, line10),
               std::invalid_argument);
}

TEST(SegmentTree, FindsWhatTestingEverySegmentFinds)
{
  boost::random::mt19937_64 random(7);
  boost::random::uniform_01<double> uniform;
  const auto point = [&] {
    const double x = uniform(random), y = uniform(random), z = uniform(random);
    return Point(10 * x, 10 * y, z);
  };
  for (const std::size_t curves : {1u, 3u, 40u}) {
    CurveNetwork network;
    for (std::size_t c = 0; c < curves; ++c) {
      Points vertices;
      for (std::size_t v = 0; v < 1 + c % 7; ++v)
        vertices.push_back(point());
      network.curves.push_back(polyline(vertices, c % 2 == 1));
    }
    const SegmentTree tree(network);
    std::size_t hint = SegmentTree::none;
    for (int i = 0; i < 500; ++i) {
      const Point query = 1.4 * point() - Point(2, 2, 0.2);
      double best = std::numeric_limits<double>::infinity();
      for (const SegmentTree::Segment& s : tree.segments()) {
        const Point edge = s.b - s.a;
        const double squared_length = std::max(edge.squaredNorm(), 1e-300);
        const double t =
            std::min(1.0, std::max(0.0, (query - s.a).dot(edge) / squared_length));
        best = std::min(best, (s.a + t * edge - query).norm());
      }
      const SegmentTree::Nearest found = tree.nearest(query, hint);
      ASSERT_NEAR(std::sqrt(found.squared_distance), best, 1e-9);
      hint = found.segment;
    }
  }
  EXPECT_EQ(SegmentTree({}).nearest({0, 0, 0}).segment, SegmentTree::none);
}
