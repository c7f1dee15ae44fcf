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
  StreamlineSettings settings;
  settings.start_points = 4; // a start an arm, as a user would ask for
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

TEST(Published, EveryBlendFollowsACircle)
{
  for (const auto& [blend, name] : Names<BlendMode>::table) {
    StreamlineSettings settings;
    settings.shape.graph.blend = blend;
    const bench::Measures m = bench::measure(
        reconstruct(Geometry::Circle, 256, settings), bench::truthOf(Geometry::Circle));
    EXPECT_LT(m.e_v, 0.1) << name;
    EXPECT_GT(m.e_com, 0.95) << name;
  }
}

TEST(Published, StartsCanBeGivenByHand)
{
  bench::SamplingSettings sampling;
  Points points = bench::sample(Geometry::Line, sampling);
  points.insert(points.begin(),
                Point(std::nan(""), 0, 0)); // places are those of the input
  StreamlineSettings settings;
  settings.starts = {101};
  settings.max_iterations = 10;
  const CurveNetwork both = reconstructPublished(points, settings);
  ASSERT_EQ(both.curves.size(), 1u);
  const Points& line = both.curves[0].points;
  EXPECT_LT((line[line.size() / 2] - points[101]).norm(), 1e-9);

  // 2012: a streamline into one direction, whichever way the eigenvector looks.
  for (const double sign : {1.0, -1.0}) {
    settings.seed_direction = {sign, 0.1, 0};
    const CurveNetwork one = reconstructPublished(points, settings);
    ASSERT_EQ(one.curves.size(), 1u);
    const Points& way = one.curves[0].points;
    const bool turned = (way.front() - points[101]).norm() > 1e-9;
    const Point begin = turned ? way.back() : way.front();
    const Point end = turned ? way.front() : way.back();
    EXPECT_LT((begin - points[101]).norm(), 1e-9);
    EXPECT_GT(sign * (end - begin).x(), 0);
    EXPECT_EQ(way.size(), 11u);
  }

  settings.starts = {static_cast<Index>(points.size())};
  EXPECT_THROW(reconstructPublished(points, settings), std::invalid_argument);
  settings.starts = {0};
  EXPECT_THROW(reconstructPublished(points, settings), std::invalid_argument) << "NaN";
  settings.starts = {1};
  settings.seed_direction = {1, 0};
  EXPECT_THROW(reconstructPublished(points, settings), std::invalid_argument);
}

TEST(Published, AStreamlineOf2012FollowsACable)
{
  // One radius, the eigenvector alone, adaptive steps and a start by hand: a catenary
  // of 280 m, 3 cm noise, as the cable that drifted by .8 m in the paper.
  Points cable;
  boost::random::mt19937_64 random(5);
  boost::random::uniform_01<double> uniform;
  const auto noise = [&] { return 0.06 * (uniform(random) - 0.5); };
  const auto sag = [](double x) { return 0.0005 * (x - 140) * (x - 140); };
  for (int i = 0; i < 1400; ++i) {
    const double x = 0.2 * i, y = noise();
    cable.emplace_back(x, y, sag(x) + noise());
  }
  StreamlineSettings settings;
  settings.shape.radii = {2};
  settings.shape.weighting = Kernel::Quadratic;
  settings.shape.centroid = Centroid::QueryPoint;
  settings.direction = DirectionMode::Eigenvector;
  settings.scheme = IntegrationScheme::Dop853Adaptive;
  settings.starts = {5};
  settings.seed_direction = {1, 0, 0};
  const CurveNetwork network = reconstructPublished(cable, settings);
  ASSERT_EQ(network.curves.size(), 1u);
  EXPECT_NEAR(length(network), 280, 5);
  for (const Point& p : network.curves[0].points)
    EXPECT_LT(std::hypot(p.y(), p.z() - sag(p.x())), 0.8);
}

TEST(Published, DirectionsOfDisagreeingNeighborsAreShorter)
{
  // Equation 4: eigenvectors that cross weigh less against the angular direction.
  Points points;
  MultiScaleShapes shapes;
  shapes.scale_unit = 1;
  shapes.radii = {1, 2.5};
  for (const float side : {-1.0F, 1.0F}) {
    points.emplace_back(0.1 * side, 0, 0);
    MultiScaleShape shape;
    shape.optimal_radius = 2.5F;
    shape.blend = 0.5F;
    shape.major_x = shape.major_y = std::sqrt(0.5F);
    shape.major_y *= side;
    shape.major_z = 0;
    shapes.shapes.push_back(shape);
  }
  const CloudNeighbors neighbors(points, 2.5);
  StreamlineSettings settings;
  const auto share = [&] {
    const DirectionField field(points, shapes, neighbors, settings);
    LocalScale scale;
    scale.radius = 2.5;
    scale.blend = 0.5;
    // d_A looks along -x: to the two points, from the right of them.
    const Point at = field.at(Point(0.5, 0, 0), Point(-0.9, 1, 0).normalized(), scale);
    return at.y() / at.norm();
  };
  // d_E = (-s, s, 0) and (-s, -s, 0) turned toward the last direction: both (-s, s) or
  // (s, s); their mean has length s = .71, its unit vector length 1.
  const double published = share();
  settings.unit_eigenvector = true;
  EXPECT_LT(std::abs(published), std::abs(share()));
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
