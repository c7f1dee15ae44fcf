// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <stdexcept>
#include <vector>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_01.hpp>

#include <linelet/features/multi_scale.h>

#include "curves/streamline/direction_field.h"
#include "curves/streamline/published_curves.h"
#include "curves/streamline/start_points.h"

using namespace linelet;
using namespace linelet::test;

// Which mode is which is tested in test_direction_field.cpp.
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
                Point(std::nan(""), 0, 0)); // positions are in the frame of the input
  StreamlineSettings settings;
  settings.starts = {101};
  settings.max_iterations = 10;
  const CurveNetwork both = reconstructPublished(points, settings);
  ASSERT_EQ(both.curves.size(), 1u);
  const Points& line = both.curves[0].points;
  EXPECT_LT((line[line.size() / 2] - points[101]).norm(), 1e-9);

  // 2012: a streamline to one side, whichever way the eigenvector points.
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

TEST(Published, StartsAreChosenAmongSomePoints)
{
  bench::SamplingSettings sampling;
  sampling.points = 200;
  const Points points = bench::sample(Geometry::Circle, sampling);
  StreamlineSettings settings;
  settings.start_points = 1;
  settings.max_iterations = 3; // a piece around the start shows where it is
  const auto startOf = [&](std::size_t candidates, unsigned seed) {
    settings.start_candidates = candidates;
    settings.shape.scale_unit_seed = seed;
    const CurveNetwork network = reconstructPublished(points, settings);
    EXPECT_EQ(network.curves.size(), 1u);
    const Points& way = network.curves.at(0).points;
    return way[way.size() / 2];
  };
  // A single candidate is the start: other seeds give others, the same seed the same.
  const Point first = startOf(1, 1);
  EXPECT_EQ(first, startOf(1, 1));
  int others = 0;
  for (unsigned seed = 2; seed < 8; ++seed)
    others += (startOf(1, seed) - first).norm() > 1e-9 ? 1 : 0;
  EXPECT_GE(others, 4);
  // As many or more means all.
  EXPECT_EQ(startOf(200, 1), startOf(0, 2));
  EXPECT_EQ(startOf(1000, 1), startOf(0, 2));
}

TEST(Published, AStreamlineOf2012FollowsACable)
{
  // One radius, the eigenvector alone, adaptive steps and a manual start: a catenary of
  // 280 m with 3 cm noise, like the cable that drifted by .8 m in the paper.
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
  // Equation 4: eigenvectors across the angular direction weigh less.
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
    // d_A points along -x, to the two points seen from their right.
    const Point at = field.at(Point(0.5, 0, 0), Point(-0.9, 1, 0).normalized(), scale);
    return at.y() / at.norm();
  };
  // d_E = (-s, s, 0) and (-s, -s, 0) turned toward the last direction: both (-s, s) or
  // (s, s); their mean has length s = .71, its unit vector length 1.
  const double published = share();
  settings.unit_eigenvector = true;
  EXPECT_LT(std::abs(published), std::abs(share()));
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

  // A hole of a tenth of the line ends it, unless the cutoff spans it.
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
  // From its only start a line reaches the bounds of the cloud on one side and, on the
  // other, a hole wider than the cutoff.
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
  // The corners of the rectangle turn by about 31 degrees per step.
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

TEST(StartPoints, TheSecondIsFarFromTheFirst)
{
  // A straight row: scores are alike except at its ends, so distance decides.
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
  // With an exponent of 1, twice the neighbors outweigh 1 % more linearity.
  shapes[20].first_neighbors = 12;
  StartPoints crowded(row, shapes, 6, 1);
  EXPECT_EQ(crowded.next(), 20u);
  StartPoints sparse(row, std::vector<MultiScaleShape>(row.size()), 6);
  EXPECT_EQ(sparse.next(), StartPoints::none);
}
