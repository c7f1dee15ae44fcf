// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/curves/refined_reconstruction.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <boost/random/uniform_real_distribution.hpp>
#include <gtest/gtest.h>

#include <bench/geometries/geometries.h>
#include <bench/geometries/test_cloud.h>
#include <bench/measures/measures.h>

using namespace linelet;
using namespace linelet::bench;

namespace {

Points
cable(double length, double per_meter, double noise, double offset, unsigned seed)
{
  boost::random::mt19937 random(seed);
  boost::random::normal_distribution<double> normal(0, noise);
  boost::random::uniform_real_distribution<double> along(-length / 2, length / 2);
  Points points;
  const double a = 800; // parameter of the catenary
  for (int i = 0; i < length * per_meter; ++i) {
    const double x = along(random);
    points.emplace_back(x + normal(random),
                        offset + normal(random),
                        a * (std::cosh(x / a) - 1) + normal(random));
  }
  return points;
}

TEST(RefinedReconstruction, DegenerateInputGivesNoCurveOrOneThatIsFinite)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(reconstructRefined({}).curves.empty());
  EXPECT_TRUE(reconstructRefined({Point(1, 2, 3)}).curves.empty());
  EXPECT_TRUE(reconstructRefined({Point(1, 2, 3), Point(2, 2, 3)}).curves.empty());
  EXPECT_TRUE(reconstructRefined(Points(500, Point(1, 2, 3))).curves.empty());
  EXPECT_TRUE(reconstructRefined(Points(500, Point(nan, nan, nan))).curves.empty());
  Points collinear;
  for (int i = 0; i < 200; ++i)
    collinear.emplace_back(1e7 + i, 1e7, -1e7);
  for (const Curve& curve : reconstructRefined(collinear).curves)
    for (const Point& p : curve.points)
      EXPECT_TRUE(p.allFinite());
  RefinedSettings settings;
  settings.distance_cutoff = nan;
  EXPECT_THROW(reconstructRefined(collinear, settings), std::invalid_argument);
}

TEST(RefinedReconstruction, SurfacesAndVolumesAreNotCurves)
{
  boost::random::mt19937 random(7);
  boost::random::uniform_real_distribution<double> uniform(-10, 10);
  Points ball, plane;
  while (ball.size() < 20000) {
    const Point p(uniform(random), uniform(random), uniform(random));
    if (p.norm() < 10)
      ball.push_back(p);
    plane.emplace_back(p.x(), p.y(), 0.3 * p.x());
  }
  EXPECT_TRUE(reconstructRefined(ball).curves.empty());
  EXPECT_TRUE(reconstructRefined(plane).curves.empty());
}

TEST(RefinedReconstruction, EndsOfLinesLieOnAverageAtTheirEnds)
{
  // The last of randomly placed points lies one mean spacing before the end.
  constexpr int lines = 60;
  constexpr double length = 10, per_unit = 6;
  double sum = 0;
  for (unsigned seed = 0; seed < lines; ++seed) {
    const CurveNetwork network =
        reconstructRefined(cable(length, per_unit, 0.05, 0, seed));
    ASSERT_EQ(network.curves.size(), 1u) << "seed " << seed;
    const Points& points = network.curves[0].points;
    sum += std::abs(points.front().x()) + std::abs(points.back().x()) - length;
  }
  EXPECT_NEAR(sum / (2 * lines), 0, 0.25 / per_unit);
}

TEST(RefinedReconstruction, CleanGeometriesSucceed)
{
  for (const Geometry geometry : benchmarkGeometries()) {
    SamplingSettings settings;
    settings.points = 256;
    const Measures m =
        measure(reconstructRefined(sample(geometry, settings)), truthOf(geometry));
    EXPECT_TRUE(m.success) << nameOf(geometry);
    EXPECT_LE(m.e_v, 0.02) << nameOf(geometry);
  }
}

TEST(RefinedReconstruction, LongCableIsOneCurveWithoutDrift)
{
  const CurveNetwork network = reconstructRefined(cable(280, 3.5, 0.03, 0, 3));
  ASSERT_EQ(network.curves.size(), 1u);
  const double a = 800;
  for (const Point& p : network.curves[0].points) {
    EXPECT_NEAR(p.y(), 0, 0.05);
    EXPECT_NEAR(p.z(), a * (std::cosh(p.x() / a) - 1), 0.05);
  }
  EXPECT_NEAR(length(network), 283, 3);
}

TEST(RefinedReconstruction, HoleIsBridgedWhereDirectionsAgree)
{
  SamplingSettings settings;
  settings.hole = {0.40, 0.52};
  const CurveNetwork circle = reconstructRefined(sample(Geometry::Circle, settings));
  ASSERT_EQ(circle.curves.size(), 1u);
  EXPECT_TRUE(circle.curves[0].closed);
  EXPECT_TRUE(measure(circle, truthOf(Geometry::Circle)).success);
  // The two sides see past each other around the first corner of the elbow.
  settings.hole = {1 / 3.0 - 0.06, 1 / 3.0 + 0.06};
  EXPECT_EQ(reconstructRefined(sample(Geometry::Elbow, settings)).curves.size(), 2u);
}

TEST(RefinedReconstruction, ParallelCablesStayTwo)
{
  Points points = cable(280, 3.5, 0.05, 0, 5);
  for (const Point& p : cable(280, 3.5, 0.05, 0.5, 6))
    points.push_back(p);
  const CurveNetwork network = reconstructRefined(points);
  EXPECT_EQ(network.curves.size(), 2u);
}

TEST(RefinedReconstruction, ParallelCablesStayTwoWhereTheirPointsAreDense)
{
  // Ridges narrow enough to separate them break at every gap between points, and wide
  // ones run between the two.
  for (unsigned seed = 1; seed <= 4; ++seed) {
    Points points = cable(280, 10, 0.05, 0, 100 + seed);
    for (const Point& p : cable(280, 10, 0.05, 0.5, 200 + seed))
      points.push_back(p);
    const CurveNetwork network = reconstructRefined(points);
    ASSERT_EQ(network.curves.size(), 2u) << "seed " << seed;
    for (const Curve& curve : network.curves) {
      const double offset = curve.points.front().y() < 0.25 ? 0 : 0.5;
      for (const Point& p : curve.points)
        EXPECT_NEAR(p.y(), offset, 0.1) << "seed " << seed << " at " << p.x();
    }
  }
}

/** \brief Arms of length 10 from the origin, a point every 0.1, none twice. */
Points
arms(const Points& directions)
{
  Points points{Point::Zero()};
  for (const Point& direction : directions)
    for (int i = 1; i <= 100; ++i)
      points.emplace_back(0.1 * i * direction.normalized());
  return points;
}

/** \brief Every end marked as a junction lies on it, and every curve of a junction has
 * a vertex there. */
void
expectConsistent(const CurveNetwork& network)
{
  for (const Junction& junction : network.junctions)
    for (const std::size_t c : junction.curves) {
      const Points& vertices = network.curves.at(c).points;
      EXPECT_TRUE(std::any_of(vertices.begin(), vertices.end(), [&](const Point& p) {
        return p == junction.position;
      }));
    }
  for (const Curve& curve : network.curves) {
    if (curve.front.kind == EndKind::Junction) {
      EXPECT_EQ(curve.points.front(),
                network.junctions.at(static_cast<std::size_t>(curve.front.junction))
                    .position);
    }
    if (curve.back.kind == EndKind::Junction) {
      EXPECT_EQ(
          curve.points.back(),
          network.junctions.at(static_cast<std::size_t>(curve.back.junction)).position);
    }
    if (!curve.support.empty()) {
      EXPECT_EQ(curve.support.size(), curve.points.size());
    }
  }
}

std::size_t
endsAtJunctions(const CurveNetwork& network)
{
  std::size_t count = 0;
  for (const Curve& curve : network.curves)
    count += (curve.front.kind == EndKind::Junction ? 1u : 0u) +
             (curve.back.kind == EndKind::Junction ? 1u : 0u);
  return count;
}

TEST(RefinedReconstruction, BranchesAreJunctionsCrossingsAreNot)
{
  const double third = 2 * M_PI / 3;
  const Points y = {{1, 0, 0},
                    {std::cos(third), std::sin(third), 0},
                    {std::cos(2 * third), std::sin(2 * third), 0}};
  const CurveNetwork branch = reconstructRefined(arms(y));
  ASSERT_EQ(branch.junctions.size(), 1u);
  EXPECT_LT(branch.junctions[0].position.norm(), 0.3);
  EXPECT_EQ(branch.junctions[0].curves.size(), branch.curves.size());
  // No two arms are collinear, so all three end there, or two form one curve.
  EXPECT_EQ(endsAtJunctions(branch), branch.curves.size() == 3 ? 3u : 1u);
  EXPECT_NEAR(length(branch), 30, 0.6);
  expectConsistent(branch);

  const CurveNetwork tee = reconstructRefined(arms({{1, 0, 0}, {-1, 0, 0}, {0, 0, 1}}));
  ASSERT_EQ(tee.curves.size(), 2u);
  ASSERT_EQ(tee.junctions.size(), 1u);
  EXPECT_LT(tee.junctions[0].position.norm(), 0.2);
  EXPECT_EQ(tee.junctions[0].curves, (std::vector<std::size_t>{0, 1}));
  EXPECT_EQ(endsAtJunctions(tee), 1u);
  expectConsistent(tee);

  const CurveNetwork crossing =
      reconstructRefined(arms({{1, 0, 0}, {-1, 0, 0}, {0, 1, 1}, {0, -1, -1}}));
  EXPECT_EQ(crossing.curves.size(), 2u);
  EXPECT_TRUE(crossing.junctions.empty());
  EXPECT_EQ(endsAtJunctions(crossing), 0u);
  for (const Curve& curve : crossing.curves)
    EXPECT_EQ(curve.front.kind, EndKind::Support);
}

TEST(RefinedReconstruction, ClosedOutlineEndsInALoop)
{
  for (const Geometry geometry :
       {Geometry::Circle, Geometry::Triangle, Geometry::Rectangle}) {
    SamplingSettings settings;
    settings.points = 256;
    const CurveNetwork network = reconstructRefined(sample(geometry, settings));
    ASSERT_EQ(network.curves.size(), 1u) << nameOf(geometry);
    EXPECT_TRUE(network.curves[0].closed) << nameOf(geometry);
    EXPECT_EQ(network.curves[0].front.kind, EndKind::Loop) << nameOf(geometry);
    EXPECT_EQ(network.curves[0].back.kind, EndKind::Loop) << nameOf(geometry);
    EXPECT_TRUE(network.junctions.empty()) << nameOf(geometry);
  }
}

TEST(RefinedReconstruction, IsEquivariantToMotionAndScale)
{
  SamplingSettings settings;
  settings.jitter = 0.3;
  settings.outliers = 40;
  const Points points = sample(Geometry::Elbow, settings);
  const CurveNetwork plain = reconstructRefined(points);
  Points moved = points;
  for (Point& p : moved)
    p = 16 * p + Point(5e5, -5e5, 1024);
  const CurveNetwork other = reconstructRefined(moved);
  ASSERT_EQ(plain.curves.size(), other.curves.size());
  EXPECT_NEAR(length(other) / (16 * length(plain)), 1, 0.01);
}

TEST(RefinedReconstruction, SameForAnyNumberOfThreads)
{
  Points points;
  for (int k = 0; k < 6; ++k)
    for (const Point& p : cable(60, 4, 0.05, 40.0 * k, static_cast<unsigned>(k)))
      points.push_back(p);
  RefinedSettings one, three;
  one.threads = 1;
  three.threads = 3;
  const CurveNetwork a = reconstructRefined(points, one);
  const CurveNetwork b = reconstructRefined(points, three);
  ASSERT_EQ(a.curves.size(), b.curves.size());
  EXPECT_GE(a.curves.size(), 6u);
  for (std::size_t c = 0; c < a.curves.size(); ++c)
    EXPECT_EQ(a.curves[c].points, b.curves[c].points);
}

TEST(RefinedReconstruction, DuplicatesAndNonFinitePointsChangeNothing)
{
  const Points points = cable(60, 4, 0.03, 0, 5);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Points more;
  for (std::size_t i = 0; i < points.size(); ++i) {
    more.push_back(points[i]);
    if (i % 2 == 1)
      more.push_back(points[i - 1]);
    if (i % 10 == 0)
      more.emplace_back(nan, 0, 0);
  }
  const CurveNetwork once = reconstructRefined(points);
  const CurveNetwork twice = reconstructRefined(more);
  ASSERT_FALSE(once.curves.empty());
  ASSERT_EQ(twice.curves.size(), once.curves.size());
  for (std::size_t c = 0; c < once.curves.size(); ++c)
    EXPECT_EQ(twice.curves[c].points, once.curves[c].points);
}

TEST(RefinedReconstruction, CanceledWorkThrows)
{
  struct Never : ProgressMonitor {
    bool
    canceled() const override
    {
      return true;
    }
  } monitor;
  EXPECT_THROW(reconstructRefined(cable(60, 4, 0.05, 0, 1), {}, &monitor), Canceled);
}

} // namespace
