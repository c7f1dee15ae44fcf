// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <limits>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_01.hpp>
#include <gtest/gtest.h>

#include <bench/geometries/test_cloud.h>
#include <bench/measures/measures.h>
#include <linelet/curves/streamline_reconstruction.h>
#include <linelet/features/multi_scale.h>

#include "curves/streamline/direction_field.h"
#include "curves/streamline/start_points.h"

using namespace linelet;
using bench::Geometry;

namespace {

CurveNetwork
reconstruct(Geometry geometry,
            std::size_t points,
            const StreamlineSettings& settings = {})
{
  bench::SamplingSettings sampling;
  sampling.points = points;
  return reconstructPublished(bench::sample(geometry, sampling), settings);
}

void
expectSame(const CurveNetwork& a, const CurveNetwork& b)
{
  ASSERT_EQ(a.curves.size(), b.curves.size());
  for (std::size_t i = 0; i < a.curves.size(); ++i)
    EXPECT_EQ(a.curves[i].points, b.curves[i].points);
}

Points
randomPoints(std::size_t count, std::uint64_t seed)
{
  boost::random::mt19937_64 random(seed);
  boost::random::uniform_01<double> uniform;
  Points points;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = uniform(random), y = uniform(random), z = uniform(random);
    points.emplace_back(x, y, z);
  }
  return points;
}

} // namespace

class CleanGeometry : public ::testing::TestWithParam<Geometry> {};

// As published, all ten succeed without noise: mean distances of 0.02 to 0.04.
TEST_P(CleanGeometry, IsReconstructed)
{
  const bench::Measures m =
      bench::measure(reconstruct(GetParam(), 256), bench::truthOf(GetParam()));
  EXPECT_TRUE(m.success) << "E_V " << m.e_v << " E_Len " << m.e_len << " E_Com "
                         << m.e_com;
  EXPECT_LT(m.e_v, 0.04);
}

INSTANTIATE_TEST_SUITE_P(Ten,
                         CleanGeometry,
                         ::testing::ValuesIn(bench::benchmarkGeometries()),
                         [](const auto& info) {
                           return std::string(nameOf(info.param));
                         });

TEST(Published, AClosedCurveIsClosed)
{
  const CurveNetwork network = reconstruct(Geometry::Circle, 256);
  ASSERT_EQ(network.curves.size(), 1u);
  EXPECT_TRUE(network.curves[0].closed);
}

TEST(Published, ACrossingHasItsFourArms)
{
  const CurveNetwork network = reconstruct(Geometry::Crossing, 256);
  ASSERT_FALSE(network.junctions.empty());
  for (const Junction& junction : network.junctions)
    EXPECT_LT(junction.position.norm(), 0.5);
  for (std::size_t j = 0; j < network.junctions.size(); ++j)
    for (const std::size_t c : network.junctions[j].curves) {
      const Curve& curve = network.curves.at(c);
      EXPECT_TRUE(curve.front.junction == static_cast<int>(j) ||
                  curve.back.junction == static_cast<int>(j));
    }
}

TEST(Published, EveryDirectionModeFollowsACircle)
{
  for (const auto& [mode, name] : Names<DirectionMode>::table) {
    StreamlineSettings settings;
    settings.direction = mode;
    const bench::Measures m = bench::measure(
        reconstruct(Geometry::Circle, 256, settings), bench::truthOf(Geometry::Circle));
    EXPECT_LT(m.e_v, 0.1) << name;
    EXPECT_GT(m.e_com, 0.95) << name;
  }
}

TEST(Published, EverySchemeFollowsAHelix)
{
  for (const auto& [scheme, name] : Names<IntegrationScheme>::table) {
    StreamlineSettings settings;
    settings.scheme = scheme;
    const bench::Measures m = bench::measure(
        reconstruct(Geometry::Helix, 256, settings), bench::truthOf(Geometry::Helix));
    EXPECT_LT(m.e_v, 0.1) << name;
    EXPECT_GT(m.e_com, 0.95) << name;
  }
}

TEST(Published, IsTheSameForAnyNumberOfThreads)
{
  bench::SamplingSettings sampling;
  sampling.jitter = 0.4;
  sampling.outliers = 50;
  sampling.points = 512;
  const Points points = bench::sample(Geometry::Mikado, sampling);
  StreamlineSettings settings;
  settings.start_points = 40; // enough for the steps to be shared out
  settings.threads = 1;
  const CurveNetwork one = reconstructPublished(points, settings);
  EXPECT_FALSE(one.curves.empty());
  for (const unsigned threads : {2u, 3u, 7u}) {
    settings.threads = threads;
    expectSame(one, reconstructPublished(points, settings));
  }
}

TEST(Published, MovesAndScalesWithItsInput)
{
  bench::SamplingSettings sampling;
  sampling.jitter = 0.2;
  Points points = bench::sample(Geometry::Helix, sampling);
  const CurveNetwork before = reconstructPublished(points);
  // Powers of two and short offsets: no coordinate is rounded otherwise.
  for (Point& p : points)
    p = 4 * p;
  const CurveNetwork scaled = reconstructPublished(points);
  ASSERT_EQ(before.curves.size(), scaled.curves.size());
  EXPECT_NEAR(length(scaled), 4 * length(before), 1e-6 * length(scaled));
}

TEST(Published, UserParametersBoundTheLineLets)
{
  StreamlineSettings settings;
  settings.start_points = 1;
  settings.max_iterations = 10;
  const CurveNetwork ten = reconstruct(Geometry::Line, 256, settings);
  ASSERT_EQ(ten.curves.size(), 1u);
  EXPECT_LE(ten.curves[0].points.size(), 21u) << "ten steps each way";
  EXPECT_EQ(ten.curves[0].front.kind, EndKind::Iterations);

  // A hole of a tenth of the line ends it, unless the cutoff reaches across.
  bench::SamplingSettings sampling;
  sampling.hole = {0.45, 0.55};
  const Points holed = bench::sample(Geometry::Line, sampling);
  settings.max_iterations = 0;
  const double half = length(reconstructPublished(holed, settings));
  settings.distance_cutoff = 1;
  const double whole = length(reconstructPublished(holed, settings));
  EXPECT_NEAR(half, 0.45 * std::sqrt(136.0), 0.3);
  EXPECT_NEAR(whole, std::sqrt(136.0), 0.3);
}

TEST(Published, AnEndSaysWhyItStopped)
{
  // From its one start a line reaches the bounds of the cloud on one side, and a hole
  // wider than the cutoff on the other.
  bench::SamplingSettings sampling;
  sampling.hole = {0.45, 0.55};
  StreamlineSettings settings;
  settings.start_points = 1;
  const CurveNetwork network =
      reconstructPublished(bench::sample(Geometry::Line, sampling), settings);
  ASSERT_EQ(network.curves.size(), 1u);
  const Curve& half = network.curves[0];
  const bool turned = half.front.kind == EndKind::Cutoff;
  EXPECT_EQ((turned ? half.back : half.front).kind, EndKind::Bounds);
  EXPECT_EQ((turned ? half.front : half.back).kind, EndKind::Cutoff);
  // The line is centered at the origin, and so is its hole.
  EXPECT_LT((turned ? half.points.front() : half.points.back()).norm(),
            (turned ? half.points.back() : half.points.front()).norm());
}

TEST(Published, ATurnBeyondTheBranchAngleIsACornerOfTheSameCurve)
{
  // The corners of the rectangle turn by about 31 degrees a step.
  StreamlineSettings settings;
  const CurveNetwork smooth = reconstruct(Geometry::Rectangle, 256, settings);
  settings.branch_angle = 179;
  expectSame(smooth, reconstruct(Geometry::Rectangle, 256, settings));
  settings.branch_angle = 20;
  const CurveNetwork branched = reconstruct(Geometry::Rectangle, 256, settings);
  ASSERT_EQ(smooth.curves.size(), 1u);
  ASSERT_EQ(branched.curves.size(), 1u);
  EXPECT_TRUE(branched.curves[0].closed);
  EXPECT_NE(branched.curves[0].points, smooth.curves[0].points);
  EXPECT_NEAR(length(branched), length(smooth), 0.01 * length(smooth));
}

TEST(Published, DegenerateInputGivesNoCurveAndNoFailure)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(reconstructPublished({}).curves.empty());
  EXPECT_TRUE(reconstructPublished({{1, 2, 3}}).curves.empty());
  EXPECT_TRUE(reconstructPublished({{1, 2, 3}, {4, 5, 6}}).curves.empty());
  EXPECT_TRUE(reconstructPublished(Points(500, Point(1, 2, 3))).curves.empty());
  EXPECT_TRUE(reconstructPublished(Points(500, Point(nan, nan, nan))).curves.empty());
}

TEST(Published, PointsThatAreNotFiniteAreLeftOut)
{
  Points points = bench::sample(Geometry::Wave, {});
  const CurveNetwork clean = reconstructPublished(points);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  points.insert(points.begin(), Point(nan, 0, 0));
  points.insert(points.begin() + 100, Point(0, infinity, 0));
  expectSame(clean, reconstructPublished(points));
}

TEST(Published, RepeatedPointsStillHaveAScale)
{
  Points points;
  for (const Point& p : bench::sample(Geometry::Line, {}))
    points.insert(points.end(), 8, p); // six others at distance 0: D would be 0
  EXPECT_NEAR(length(reconstructPublished(points)), std::sqrt(136.0), 0.3);
}

TEST(Published, HugeCoordinatesKeepTheCurve)
{
  Points points = bench::sample(Geometry::Circle, {});
  for (Point& p : points)
    p += Point(5e5, 5.5e6, 100);
  EXPECT_NEAR(length(reconstructPublished(points)), 10 * M_PI, 0.3);
}

TEST(Published, FilledVolumesAndPlanesComeToAnEnd)
{
  Points ball = randomPoints(8000, 1), plane = ball;
  for (Point& p : plane)
    p.z() = 0;
  // What comes out is of no use, but it must come, and be finite.
  for (const Points& points : {ball, plane})
    EXPECT_TRUE(std::isfinite(length(reconstructPublished(points))));
}

TEST(Published, RefusesParametersOutOfRange)
{
  const Points points = bench::sample(Geometry::Line, {});
  StreamlineSettings settings;
  settings.step = 0;
  EXPECT_THROW(reconstructPublished(points, settings), std::invalid_argument);
  settings = {};
  settings.distance_cutoff = -1;
  EXPECT_THROW(reconstructPublished(points, settings), std::invalid_argument);
  settings = {};
  settings.branch_angle = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(reconstructPublished(points, settings), std::invalid_argument);
}

TEST(Published, CanBeCanceled)
{
  struct : ProgressMonitor {
    bool
    canceled() const override
    {
      return true;
    }
  } monitor;
  EXPECT_THROW(reconstructPublished(bench::sample(Geometry::Line, {}), {}, &monitor),
               Canceled);
}

TEST(StartPoints, TheSecondIsFarFromTheFirst)
{
  // A straight row: scores are alike but at its ends, so that distance decides.
  Points row;
  for (int i = 0; i < 101; ++i)
    row.emplace_back(0.1 * i, 0, 0);
  std::vector<MultiScaleShape> shapes(row.size());
  for (MultiScaleShape& shape : shapes) {
    shape.linearity_sum = 5;
    shape.linearity_max = 1;
    shape.optimal_radius = 1;
    shape.first_neighbors = 6;
  }
  shapes[50].linearity_max = 1.01F;
  shapes[100].first_neighbors = 5; // too few
  StartPoints starts(row, shapes, 6);
  EXPECT_EQ(starts.next(), 50u);
  EXPECT_EQ(starts.next(), 0u);
  EXPECT_EQ(starts.next(), 99u);
  // With an exponent of 1 twice the neighbors outweigh 1 % more linearity.
  shapes[20].first_neighbors = 12;
  StartPoints crowded(row, shapes, 6, 1);
  EXPECT_EQ(crowded.next(), 20u);
  StartPoints sparse(row, std::vector<MultiScaleShape>(row.size()), 6);
  EXPECT_EQ(sparse.next(), StartPoints::none);
}
