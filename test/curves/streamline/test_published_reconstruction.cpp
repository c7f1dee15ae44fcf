// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_01.hpp>

#include "curves/streamline/published_curves.h"

using namespace linelet;
using namespace linelet::test;

namespace {

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
  StreamlineSettings settings;
  settings.start_points = 4; // one start per arm, as a user would set
  const CurveNetwork network = reconstruct(Geometry::Crossing, 260, settings);
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

TEST(Published, IsTheSameForAnyNumberOfThreads)
{
  bench::SamplingSettings sampling;
  sampling.jitter = 0.4;
  sampling.outliers = 50;
  sampling.points = 512;
  const Points points = bench::sample(Geometry::Mikado, sampling);
  StreamlineSettings settings;
  settings.start_points = 40; // enough for the steps to be shared among threads
  settings.threads = 1;
  const CurveNetwork one = reconstructPublished(points, settings);
  EXPECT_FALSE(one.curves.empty());
  for (const unsigned threads : {2u, 3u, 7u}) {
    settings.threads = threads;
    expectSame(one, reconstructPublished(points, settings));
  }
}

TEST(Published, IsEquivariantToMotionAndScale)
{
  bench::SamplingSettings sampling;
  sampling.jitter = 0.2;
  Points points = bench::sample(Geometry::Helix, sampling);
  const CurveNetwork before = reconstructPublished(points);
  // Powers of two and short offsets, so that no coordinate is rounded differently.
  for (Point& p : points)
    p = 4 * p;
  const CurveNetwork scaled = reconstructPublished(points);
  ASSERT_EQ(before.curves.size(), scaled.curves.size());
  EXPECT_NEAR(length(scaled), 4 * length(before), 1e-6 * length(scaled));
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

TEST(Published, FilledVolumesAndPlanesTerminate)
{
  Points ball = randomPoints(8000, 1), plane = ball;
  for (Point& p : plane)
    p.z() = 0;
  // The result is useless, but there must be one, and it must be finite.
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
