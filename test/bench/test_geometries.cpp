// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <tuple>

#include <gtest/gtest.h>

#include <bench/geometries/geometries.h>
#include <bench/geometries/test_cloud.h>
#include <bench/measures/segment_tree.h>
#include <bench/runs/benchmark_grid.h>

using namespace linelet;
using namespace linelet::bench;

namespace {

double
distanceTo(const SegmentTree& tree, const Point& p)
{
  return std::sqrt(tree.nearest(p).squared_distance);
}

} // namespace

TEST(Geometries, HaveTheLengthsOfTheirDefinitions)
{
  const std::map<Geometry, double> lengths = {
      {Geometry::Circle, 10 * M_PI},
      {Geometry::Rectangle, 36},
      {Geometry::Triangle, 30},
      {Geometry::Line, std::sqrt(136.0)},
      {Geometry::Crossing, 20 * std::sqrt(2.0)},
      {Geometry::Elbow, 15},
      {Geometry::Helix, std::hypot(12 * M_PI, 10)},
      {Geometry::Mikado,
       std::sqrt(108.0) + 10 + std::sqrt(104.25) + std::sqrt(12.25 + 6.25 + 81)},
      {Geometry::Crossing3d, 30},
      {Geometry::Parallel, 20},
      {Geometry::Vee, 20},
      {Geometry::SCurve, 5 * M_PI}};
  for (const auto& [geometry, expected] : lengths)
    EXPECT_NEAR(length(truthOf(geometry)), expected, 1e-4 * expected)
        << nameOf(geometry);
}

TEST(Geometries, EveryNameStandsForOneOfTheTenOrIsHeldOut)
{
  std::set<Geometry> all(benchmarkGeometries().begin(), benchmarkGeometries().end());
  EXPECT_EQ(all.size(), 10u);
  all.insert(heldOutGeometries().begin(), heldOutGeometries().end());
  EXPECT_EQ(all.size(), Names<Geometry>::table.size());
  std::set<std::string_view> names;
  for (const auto& entry : Names<Geometry>::table)
    names.insert(entry.second);
  EXPECT_EQ(names.size(), all.size());
}

TEST(Geometries, AreBentOutOfPlaneByACosineOfY)
{
  // Rectangle: y in [-4, 4], so that z = S cos(pi/2 y/16).
  const CurveNetwork bent = truthOf(Geometry::Rectangle, 2);
  EXPECT_GT(bent.curves[0].points.size(), 100u);
  for (const Point& p : bent.curves[0].points)
    EXPECT_NEAR(p.z(), 2 * std::cos(M_PI / 2 * p.y() / 16), 1e-12);
}

TEST(Sampling, NoiseFreeSamplesLieOnTheCurveEvenly)
{
  for (const auto& entry : Names<Geometry>::table) {
    SamplingSettings settings;
    settings.points = 300;
    const Points points = sample(entry.first, settings);
    ASSERT_EQ(points.size(), 300u) << entry.second;
    const SegmentTree tree(truthOf(entry.first));
    for (const Point& p : points)
      ASSERT_LT(distanceTo(tree, p), 1e-9) << entry.second;
  }
  const Points line = sample(Geometry::Line, {});
  for (std::size_t i = 0; i < line.size(); ++i)
    EXPECT_NEAR((line[i] - Point(-5, -3, 0)).norm(),
                std::sqrt(136.0) * static_cast<double>(i) / 256,
                1e-9);
}

TEST(Sampling, ComponentsGetSamplesByTheirLength)
{
  SamplingSettings settings;
  settings.points = 512;
  const CurveNetwork truth = truthOf(Geometry::Mikado);
  const SegmentTree tree(truth);
  std::vector<double> counts(truth.curves.size());
  for (const Point& p : sample(Geometry::Mikado, settings))
    counts[tree.segments()[tree.nearest(p).segment].curve] += 1;
  for (std::size_t c = 0; c < counts.size(); ++c)
    EXPECT_NEAR(counts[c], 512 * length(truth.curves[c]) / length(truth), 1.01);
}

TEST(Sampling, JitterDisplacesByExactlyItsAmplitude)
{
  SamplingSettings settings;
  settings.jitter = 0.7;
  const Points noisy = sample(Geometry::Helix, settings);
  settings.jitter = 0;
  const Points clean = sample(Geometry::Helix, settings);
  Point mean = Point::Zero();
  for (std::size_t i = 0; i < clean.size(); ++i) {
    EXPECT_NEAR((noisy[i] - clean[i]).norm(), 0.7, 1e-9);
    mean += (noisy[i] - clean[i]) / static_cast<double>(clean.size());
  }
  EXPECT_LT(mean.norm(), 4 * 0.7 / std::sqrt(256.0)); // no direction is preferred
}

TEST(Sampling, FollowsTheRandomNumbersThatTheStandardFixes)
{
  // The C++ standard fixes the sequence of mt19937_64; with S_D = 1, the arc position
  // of a single sample is its first number over 2^64.
  SamplingSettings settings;
  settings.points = 1;
  settings.distribution = 1;
  settings.seed = 42;
  std::mt19937_64 reference(42);
  const double r = std::ldexp(static_cast<double>(reference()), -64);
  const Point expected = Point(-5, -3, 0) + r * Point(10, 6, 0);
  EXPECT_NEAR((sample(Geometry::Line, settings)[0] - expected).norm(), 0, 1e-9);
}

TEST(Sampling, HoleLeavesOutItsPartOfTheArc)
{
  SamplingSettings settings;
  settings.points = 1000;
  settings.hole = {0.25, 0.5};
  const Points points = sample(Geometry::Line, settings);
  EXPECT_NEAR(static_cast<double>(points.size()), 750, 1.01);
  for (const Point& p : points)
    EXPECT_TRUE(p.x() < -2.5 || p.x() > 0);
}

TEST(Sampling, OutliersFillTheEnlargedBox)
{
  SamplingSettings settings;
  settings.outliers = 2000;
  Points points = sample(Geometry::Circle, settings);
  ASSERT_EQ(points.size(), 2256u);
  const double margin = 0.1 * std::sqrt(200.0);
  double widest = 0;
  for (const Point& p : points) {
    EXPECT_EQ(p.z(), 0) << "a flat cloud without jitter stays flat";
    widest = std::max(widest, p.head<2>().cwiseAbs().maxCoeff());
  }
  EXPECT_LE(widest, 5 + margin + 1e-9);
  EXPECT_GT(widest, 5 + 0.9 * margin);
  settings.jitter = 0.1;
  points = sample(Geometry::Circle, settings);
  double highest = 0;
  for (const Point& p : points)
    highest = std::max(highest, std::abs(p.z()));
  EXPECT_GT(highest, margin * 0.9);
}

TEST(Sampling, VaryingDensityFallsFourfold)
{
  SamplingSettings settings;
  settings.points = 1001;
  const Points points = sample(Geometry::SCurve, settings);
  const double first = (points[1] - points[0]).norm();
  const double last = (points[1000] - points[999]).norm();
  EXPECT_NEAR(last / first, 4, 0.1);
}

TEST(Sampling, RefusesSettingsOutOfRange)
{
  SamplingSettings settings;
  settings.distribution = 1.5;
  EXPECT_THROW(sample(Geometry::Line, settings), std::invalid_argument);
  settings = {};
  settings.jitter = -1;
  EXPECT_THROW(sample(Geometry::Line, settings), std::invalid_argument);
  settings = {};
  settings.hole = {0.5, 0.2};
  EXPECT_THROW(sample(Geometry::Line, settings), std::invalid_argument);
  settings = {};
  settings.points = 0;
  settings.outliers = 5;
  EXPECT_TRUE(sample(Geometry::Line, settings).empty());
}

namespace {

auto
key(const BenchmarkRun& run)
{
  const SamplingSettings& s = run.sampling;
  return std::make_tuple(
      run.geometry, s.points, s.distribution, s.jitter, s.outliers, s.seed);
}

} // namespace

TEST(BenchmarkGrid, HoldsEachOfTheRunsOnce)
{
  const BenchmarkGrid grid;
  ASSERT_EQ(grid.size(), 127050u);
  std::set<decltype(key(grid.at(0)))> runs;
  for (std::size_t i = 0; i < grid.size(); ++i)
    runs.insert(key(grid.at(i)));
  EXPECT_EQ(runs.size(), grid.size());
  const BenchmarkRun last = grid.at(grid.size() - 1);
  EXPECT_EQ(last.geometry, Geometry::Crossing3d);
  EXPECT_EQ(last.sampling.points, 512u);
  EXPECT_EQ(last.sampling.distribution, 1);
  EXPECT_EQ(last.sampling.jitter, 1);
  EXPECT_EQ(last.sampling.outliers, 204u);
  EXPECT_EQ(last.sampling.seed, 7u);
}

TEST(BenchmarkGrid, SampleIsBalancedOverEveryNoise)
{
  const BenchmarkGrid grid;
  const auto sample = grid.stratifiedSample(660, 3);
  ASSERT_EQ(std::set<std::size_t>(sample.begin(), sample.end()).size(), 660u);
  EXPECT_TRUE(std::is_sorted(sample.begin(), sample.end()));
  std::map<std::tuple<Geometry, std::size_t, double>, int> strata;
  std::map<double, int> distributions;
  for (const std::size_t index : sample) {
    const BenchmarkRun run = grid.at(index);
    ++strata[{run.geometry, run.sampling.points, run.sampling.jitter}];
    ++distributions[run.sampling.distribution];
  }
  EXPECT_EQ(strata.size(), 330u);
  for (const auto& entry : strata)
    EXPECT_EQ(entry.second, 2);
  for (const auto& entry : distributions)
    EXPECT_NEAR(entry.second, 60, 3); // runs drawn twice move on to the next one
  EXPECT_EQ(sample, grid.stratifiedSample(660, 3));
  EXPECT_NE(sample, grid.stratifiedSample(660, 4));
  EXPECT_EQ(grid.stratifiedSample(0, 1).size(), grid.size());
  EXPECT_EQ(grid.stratifiedSample(1000000, 1).size(), grid.size());
}
