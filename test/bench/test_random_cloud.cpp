// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <set>
#include <string>
#include <utility>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <bench/geometries/random_cloud.h>
#include <bench/measures/segment_tree.h>
#include <bench/runs/benchmark.h>
#include <bench/runs/random_runs.h>

using namespace linelet;
using namespace linelet::bench;

namespace {

/** \brief Root mean square distance of the points of \a cloud from its curves, in its
 * unit. */
double
spreadOf(const RandomCloud& cloud)
{
  const SegmentTree tree(cloud.truth);
  double sum = 0;
  for (const Point& p : cloud.points)
    sum += tree.nearest(p).squared_distance;
  return std::sqrt(sum / static_cast<double>(cloud.points.size())) / cloud.unit;
}

SamplingSettings
samplingOf(std::size_t points, double jitter, std::uint64_t seed)
{
  SamplingSettings sampling;
  sampling.points = points;
  sampling.jitter = jitter;
  sampling.seed = seed;
  return sampling;
}

} // namespace

TEST(RandomShapes, FillTheirBoxAndKeepTheirGap)
{
  for (const auto& family : Names<ShapeFamily>::table)
    for (const bool flat : {true, false}) {
      Random random(7);
      const CurveNetwork shape = randomShape(family.first, flat, 1.2, random);
      Eigen::AlignedBox3d box;
      for (const Curve& curve : shape.curves)
        for (const Point& p : curve.points)
          box.extend(p);
      EXPECT_NEAR(box.sizes().maxCoeff(), 10, 1e-9) << family.second;
      EXPECT_LT(box.center().norm(), 1e-9);
      EXPECT_EQ(box.sizes().z() > 0, !flat) << family.second;
    }
}

TEST(RandomShapes, ParallelCurvesStayAtTheirDistance)
{
  Random random(3);
  const CurveNetwork shape = randomShape(ShapeFamily::Parallel, false, 1, random);
  ASSERT_GE(shape.curves.size(), 2u);
  const CurveNetwork first{{shape.curves[0]}, {}};
  const SegmentTree tree(first);
  for (const Point& p : shape.curves[1].points) {
    const double distance = std::sqrt(tree.nearest(p).squared_distance);
    EXPECT_GT(distance, 0.9);
    EXPECT_LT(distance, 2.2);
  }
}

TEST(RandomShapes, BranchesBeginOnOtherCurves)
{
  Random random(5);
  const CurveNetwork tree = randomShape(ShapeFamily::Tree, false, 1, random);
  ASSERT_EQ(tree.junctions.size() + 1, tree.curves.size());
  for (const Junction& junction : tree.junctions) {
    const CurveNetwork parent{{tree.curves[junction.curves[0]]}, {}};
    EXPECT_LT(SegmentTree(parent).nearest(junction.position).squared_distance, 1e-18);
    EXPECT_LT((tree.curves[junction.curves[1]].points[0] - junction.position).norm(),
              1e-9);
  }
}

TEST(RandomCloud, NamesAreReadBack)
{
  std::set<std::string> names;
  for (const BenchmarkRun& run : randomRuns(48, 1)) {
    const std::string name = kindName(*run.random);
    names.insert(name);
    ASSERT_TRUE(randomCloudKind(name));
    EXPECT_EQ(kindName(*randomCloudKind(name)), name);
  }
  EXPECT_EQ(names.size(), 48u);
  EXPECT_TRUE(names.count("random-tree-2d-student"));
  EXPECT_FALSE(randomCloudKind("circle"));
}

TEST(RandomCloud, WithoutNoiseLiesOnItsCurves)
{
  for (const BenchmarkRun& run : randomRuns(48, 2)) {
    const RandomCloud cloud =
        randomCloud(*run.random, samplingOf(200, 0, run.sampling.seed));
    EXPECT_LT(spreadOf(cloud), 1e-7) << kindName(*run.random);
  }
}

TEST(RandomCloud, NoiseIsAsWideAsItSays)
{
  const auto spread = [](NoiseKind noise) {
    return spreadOf(
        randomCloud({ShapeFamily::Open, false, noise}, samplingOf(20000, 0.3, 11)));
  };
  // Across a curve, two thirds of the squares.
  const double across = std::sqrt(2.0 / 3) * 0.3;
  EXPECT_NEAR(spread(NoiseKind::FixedRadius), across, 0.03 * across);
  EXPECT_NEAR(spread(NoiseKind::Normal), across, 0.03 * across);
  EXPECT_NEAR(spread(NoiseKind::Student), across, 0.2 * across); // heavy tails
  EXPECT_LT(spread(NoiseKind::Varying), 0.8 * across);
  EXPECT_GT(spread(NoiseKind::Varying), across / 9);
}

TEST(RandomCloud, FlatOnesStayInTheirPlane)
{
  SamplingSettings sampling = samplingOf(300, 0.4, 3);
  sampling.outliers = 100;
  const RandomCloud cloud =
      randomCloud({ShapeFamily::Closed, true, NoiseKind::Normal}, sampling);
  ASSERT_EQ(cloud.points.size(), 400u);
  Point mean = Point::Zero();
  for (const Point& p : cloud.points)
    mean += p / 400;
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Point& p : cloud.points)
    spread += (p - mean) * (p - mean).transpose() / 400;
  const Eigen::Vector3d values =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvalues();
  EXPECT_LT(values[0], 1e-18 * values[2]);
  EXPECT_GT(values[1], 0.01 * values[2]);
}

TEST(RandomCloud, FollowsFromItsSeed)
{
  const RandomCloudKind kind{ShapeFamily::Tree, false, NoiseKind::Student};
  const auto first = [&](std::uint64_t seed) {
    return randomCloud(kind, samplingOf(50, 0.1, seed)).points.front();
  };
  EXPECT_EQ(first(4), first(4));
  EXPECT_NE(first(4), first(5));
}

TEST(RandomRuns, AreMeasuredInTheUnitOfTheirShape)
{
  // The truth itself, shifted by a hundredth of its extent.
  for (const BenchmarkRun& run : randomRuns(12, 9)) {
    const RandomCloud cloud = randomCloud(*run.random, run.sampling);
    const Point shift = 0.1 * cloud.unit * Point(0.6, 0, 0.8);
    const BenchmarkRow row = perform("shifted", run, [&](const Points&, auto*) {
      // Completeness counts the edges both of whose ends project onto one branch, so
      // the edges are short.
      CurveNetwork found = cloud.truth;
      for (Curve& curve : found.curves) {
        const Points corners = std::move(curve.points);
        curve.points = {corners.front() + shift};
        for (std::size_t k = 1; k < corners.size(); ++k)
          for (int part = 1; part <= 50; ++part)
            curve.points.emplace_back(
                corners[k - 1] + part / 50.0 * (corners[k] - corners[k - 1]) + shift);
      }
      return found;
    });
    EXPECT_NEAR(row.measures.e_len, 1, 1e-9);
    EXPECT_LT(row.measures.e_v, 0.1 + 1e-6);
    EXPECT_GT(row.measures.e_v, 0.01);
    EXPECT_TRUE(row.measures.success);
  }
}
