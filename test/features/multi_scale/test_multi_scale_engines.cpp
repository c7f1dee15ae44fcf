// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <linelet/features/multi_scale.h>
#include <linelet/search/kd_tree.h>

#include "multi_scale_clouds.h"

namespace {

using linelet::Centroid;
using linelet::isUnbounded;
using linelet::Kernel;
using linelet::MultiScaleSettings;
using linelet::MultiScaleShape;
using linelet::MultiScaleShapes;
using linelet::multiScaleShapes;
using linelet::Point;
using linelet::Points;
using linelet::ScaleEngine;
using linelet_test::graphsOf;
using linelet_test::nan;
using linelet_test::randomPoints;

TEST(MultiScaleEngines, SameForAnyNumberOfThreads)
{
  const Points cloud = randomPoints(5000, 7, {10, 3, 1});
  MultiScaleSettings settings;
  settings.max_radius = 1.5;
  settings.threads = 1;
  MultiScaleShapes one, many;
  const auto graphs_of_one = graphsOf(cloud, cloud, settings, &one);
  settings.threads = 5;
  const auto graphs_of_many = graphsOf(cloud, cloud, settings, &many);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    ASSERT_EQ(one.shapes[i].optimal_radius, many.shapes[i].optimal_radius);
    ASSERT_EQ(one.shapes[i].linearity_sum, many.shapes[i].linearity_sum);
    ASSERT_EQ(one.shapes[i].major_x, many.shapes[i].major_x);
    for (std::size_t k = 0; k < graphs_of_one[i].size(); ++k)
      ASSERT_FALSE(graphs_of_one[i][k].linearity < graphs_of_many[i][k].linearity ||
                   graphs_of_one[i][k].linearity > graphs_of_many[i][k].linearity);
  }
  // Requesting the graphs changes nothing.
  const MultiScaleShapes silent = multiScaleShapes(cloud, cloud, settings);
  for (std::size_t i = 0; i < cloud.size(); ++i)
    ASSERT_EQ(silent.shapes[i].optimal_radius, one.shapes[i].optimal_radius);
}

/// The results of both engines, scale by scale.
void
expectSameShapes(const Points& surface,
                 const Points& queries,
                 MultiScaleSettings settings)
{
  MultiScaleShapes sweep, grid;
  settings.engine = ScaleEngine::Sweep;
  const auto graphs_of_sweep = graphsOf(surface, queries, settings, &sweep);
  settings.engine = ScaleEngine::Grid;
  const auto graphs_of_grid = graphsOf(surface, queries, settings, &grid);
  ASSERT_EQ(sweep.radii, grid.radii);
  for (std::size_t i = 0; i < queries.size(); ++i) {
    ASSERT_EQ(sweep.shapes[i].first_neighbors, grid.shapes[i].first_neighbors);
    if (!std::isnan(sweep.shapes[i].min_sphericity)) {
      ASSERT_NEAR(sweep.shapes[i].min_sphericity, grid.shapes[i].min_sphericity, 1e-4);
      ASSERT_NEAR(sweep.shapes[i].linearity_max, grid.shapes[i].linearity_max, 1e-4);
    }
    for (std::size_t k = 0; k < sweep.radii.size(); ++k) {
      const auto &a = graphs_of_sweep[i][k], &b = graphs_of_grid[i][k];
      ASSERT_EQ(a.neighbors, b.neighbors) << "query " << i << " scale " << k;
      ASSERT_EQ(std::isnan(a.linearity), std::isnan(b.linearity))
          << "query " << i << " scale " << k;
      if (std::isnan(a.linearity))
        continue;
      ASSERT_NEAR(a.linearity, b.linearity, 1e-4);
      ASSERT_NEAR(a.planarity, b.planarity, 1e-4);
      ASSERT_NEAR(a.sphericity, b.sphericity, 1e-4);
      if (a.linearity > 0.1F) {
        const float dot =
            a.major_x * b.major_x + a.major_y * b.major_y + a.major_z * b.major_z;
        ASSERT_NEAR(std::abs(dot), 1, 1e-4);
      }
    }
  }
}

/// Points on a lattice: many pairs are exactly a radius apart.
Points
lattice(int side, double step)
{
  Points points;
  for (int x = 0; x < side; ++x)
    for (int y = 0; y < side; ++y)
      for (int z = 0; z < 3; ++z)
        points.push_back(Point(x, y, z) * step);
  return points;
}

TEST(MultiScaleEngines, AgreeForEveryKernelAndMean)
{
  const unsigned seed = 12;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Points cloud = randomPoints(1200, seed, {10, 4, 0.5});
  cloud.push_back(cloud[5]); // a coincident pair
  const Points queries(cloud.begin(), cloud.begin() + 150);
  for (const auto& [kernel, name] : linelet::Names<Kernel>::table) {
    if (kernel == Kernel::FermiDirac || kernel == Kernel::Step)
      continue; // have parameters
    SCOPED_TRACE(std::string(name));
    for (const Centroid centroid :
         {Centroid::QueryPoint, Centroid::Mean, Centroid::WeightedMean}) {
      if (isUnbounded(kernel) && centroid != Centroid::QueryPoint)
        continue; // refused
      MultiScaleSettings settings;
      settings.weighting = kernel;
      settings.centroid = centroid;
      settings.max_radius = 3;
      ASSERT_NO_FATAL_FAILURE(expectSameShapes(cloud, queries, settings));
    }
  }
}

// The search stops at the extent of the cloud, but weights use the requested radii.
TEST(MultiScaleEngines, AgreeBeyondTheDiagonal)
{
  const Points cloud = randomPoints(700, 16, {10, 4, 0.5});
  const Points queries(cloud.begin(), cloud.begin() + 40);
  for (const auto& [kernel, name] : linelet::Names<Kernel>::table) {
    if (kernel == Kernel::FermiDirac || kernel == Kernel::Step)
      continue; // have parameters
    SCOPED_TRACE(std::string(name));
    for (const Centroid centroid : {Centroid::QueryPoint, Centroid::Mean}) {
      if (isUnbounded(kernel) && centroid != Centroid::QueryPoint)
        continue; // refused
      MultiScaleSettings settings;
      settings.weighting = kernel;
      settings.centroid = centroid;
      settings.radii = {0.5, 3, 12, 25, 60, 1e3, 1e6};
      ASSERT_NO_FATAL_FAILURE(expectSameShapes(cloud, queries, settings));
    }
  }
  MultiScaleSettings settings;
  settings.radii = {100, 995, 1010};
  ASSERT_NO_FATAL_FAILURE(
      expectSameShapes(cloud, {Point(1000, 0, 0), Point(0, 3000, 0)}, settings));
}

// Processor time of one run compared with another: a hundred times as much if each
// query were processed on its own.
TEST(MultiScaleEngines, CostNoMoreBeyondTheDiagonal)
{
  const Points cloud = randomPoints(3000, 17, {10, 4, 0.5});
  const auto processorTime = [&](Kernel kernel, double radius) {
    MultiScaleSettings settings;
    settings.engine = ScaleEngine::Grid;
    settings.weighting = kernel;
    settings.radii = {0.5, 3, radius};
    settings.threads = 1;
    const std::clock_t begin = std::clock();
    multiScaleShapes(cloud, cloud, settings);
    return static_cast<double>(std::clock() - begin);
  };
  for (const Kernel kernel : {Kernel::Const, Kernel::FermiDirac1}) {
    SCOPED_TRACE(nameOf(kernel));
    const double at_diagonal = processorTime(kernel, 11);
    EXPECT_LT(processorTime(kernel, 1e5), 25 * at_diagonal + CLOCKS_PER_SEC / 10);
  }
}

// Where the weight ends in a step, rounding of the coordinates must not decide the
// weight of a point on the ball.
TEST(MultiScaleEngines, AgreeOnTheWeightOfPointsOnTheBall)
{
  const Points cloud = randomPoints(1200, 15, {10, 4, 0.5});
  const linelet::KdTree tree(cloud);
  linelet::Indices near;
  for (std::size_t i = 0; i < 300; ++i) {
    MultiScaleSettings settings;
    settings.weighting = Kernel::EaseExponential;
    for (const std::size_t count : {7, 8, 12, 40})
      settings.radii.push_back(tree.nearest(cloud[i], count, near));
    settings.scale_unit = 0.3;
    SCOPED_TRACE("point " + std::to_string(i));
    ASSERT_NO_FATAL_FAILURE(expectSameShapes(cloud, {cloud[i]}, settings));
  }
}

TEST(MultiScaleEngines, AgreeForMediansAndSteps)
{
  const Points cloud = randomPoints(300, 14, {4, 2, 1});
  MultiScaleSettings settings;
  settings.max_radius = 1;
  for (const Centroid centroid : {Centroid::Median, Centroid::WeightedMedian}) {
    settings.centroid = centroid;
    ASSERT_NO_FATAL_FAILURE(expectSameShapes(cloud, cloud, settings));
  }
  settings.centroid = Centroid::QueryPoint;
  settings.weighting = linelet::Weighting::step(0.5);
  ASSERT_NO_FATAL_FAILURE(expectSameShapes(cloud, cloud, settings));
}

TEST(MultiScaleEngines, AgreeOnCloudsThatAreHardForFloat)
{
  std::vector<Points> clouds;
  clouds.push_back(lattice(25, 0.25));
  Points line; // leaves are wide compared with the smallest radii
  for (const Point& p : randomPoints(2500, 3, {2500, 0.2, 0.2}))
    line.push_back(p);
  clouds.push_back(line);
  Points heaps; // dense clusters, wide gaps, and isolated points
  for (int heap = 0; heap < 12; ++heap)
    for (const Point& p :
         randomPoints(80, 100u + static_cast<unsigned>(heap), {0.01, 0.01, 0.002}))
      heaps.push_back(p + Point(heap * 7, heap % 3 * 5, 0));
  for (const Point& p : randomPoints(100, 4, {80, 20, 5}))
    heaps.push_back(p);
  clouds.push_back(heaps);
  Points doubled = randomPoints(400, 5, {3, 3, 3}); // every point twice
  doubled.insert(doubled.end(), doubled.begin(), doubled.begin() + 400);
  clouds.push_back(doubled);
  Points far = randomPoints(800, 6, {5, 5, 0.1}); // map coordinates
  for (Point& p : far)
    p += Point(650000, 5.4e6, 300);
  clouds.push_back(far);
  for (std::size_t c = 0; c < clouds.size(); ++c)
    for (const Kernel kernel : {Kernel::Const, Kernel::FermiDirac1})
      for (const Centroid centroid :
           {Centroid::QueryPoint, Centroid::Mean, Centroid::WeightedMean}) {
        SCOPED_TRACE("cloud " + std::to_string(c));
        MultiScaleSettings settings;
        settings.weighting = kernel;
        settings.centroid = centroid;
        settings.radii = {0.25, 0.5, 0.75, 1.25, 2, 3, 12};
        ASSERT_NO_FATAL_FAILURE(expectSameShapes(clouds[c], clouds[c], settings));
      }
}

TEST(MultiScaleEngines, AgreeWhereQueriesAreNotOfTheSurface)
{
  const Points surface = randomPoints(2000, 20, {6, 6, 0.3});
  Points queries = randomPoints(300, 21, {7, 7, 1});
  queries.push_back(surface[3]); // one that is
  queries.push_back(Point(1000, 0, 0));
  queries.push_back(Point(nan, 0, 0));
  MultiScaleSettings settings;
  settings.max_radius = 2;
  for (const Kernel kernel : {Kernel::Const, Kernel::FermiDirac1}) {
    settings.weighting = kernel;
    ASSERT_NO_FATAL_FAILURE(expectSameShapes(surface, queries, settings));
  }
}

TEST(MultiScaleEngines, AgreeForManyRadiiOfLinearGrowth)
{
  const Points cloud = randomPoints(1500, 30, {6, 3, 0.4});
  MultiScaleSettings settings;
  settings.growth = linelet::RadiusGrowth::Linear;
  for (const Kernel kernel : {Kernel::Const, Kernel::FermiDirac1}) {
    settings.weighting = kernel;
    settings.max_radius = 3;
    ASSERT_NO_FATAL_FAILURE(expectSameShapes(cloud, cloud, settings));
  }
}

TEST(MultiScaleEngines, GridIsTheSameForAnyNumberOfThreads)
{
  const Points cloud = randomPoints(9000, 7, {10, 5, 1});
  MultiScaleSettings settings;
  settings.engine = ScaleEngine::Grid;
  settings.max_radius = 1.5;
  for (const Kernel kernel : {Kernel::Const, Kernel::FermiDirac1}) {
    settings.weighting = kernel;
    settings.threads = 1;
    const MultiScaleShapes one = multiScaleShapes(cloud, cloud, settings);
    settings.threads = 5;
    MultiScaleShapes many;
    graphsOf(cloud, cloud, settings, &many); // requesting them changes nothing
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      ASSERT_EQ(one.shapes[i].optimal_radius, many.shapes[i].optimal_radius);
      ASSERT_EQ(one.shapes[i].linearity_sum, many.shapes[i].linearity_sum);
      ASSERT_EQ(one.shapes[i].min_sphericity, many.shapes[i].min_sphericity);
      ASSERT_EQ(one.shapes[i].major_x, many.shapes[i].major_x);
    }
  }
}

TEST(MultiScaleEngines, TheStopRuleIsTheSameOnBoth)
{
  const Points cloud = randomPoints(1500, 40, {3, 3, 0.3});
  for (const Centroid centroid : {Centroid::Mean, Centroid::Median})
    for (const double change : {0.3, 0.05, 0.004}) {
      MultiScaleSettings settings;
      settings.weighting = Kernel::Const;
      settings.centroid = centroid;
      settings.radii = {0.3, 0.5, 0.8, 1.2, 1.8, 2.7, 4, 6, 9, 13};
      if (centroid == Centroid::Median)
        settings.radii = {0.2, 0.25, 0.3};
      settings.stop_change = change;
      settings.engine = ScaleEngine::Sweep;
      const auto sweep = linelet::multiScaleRadii(cloud, settings).radii;
      settings.engine = ScaleEngine::Grid;
      EXPECT_EQ(sweep, linelet::multiScaleRadii(cloud, settings).radii);
      if (centroid == Centroid::Mean) {
        EXPECT_LT(sweep.back(), 13); // stops before the end
      }
    }
}

TEST(MultiScaleEngines, AutoTakesTheSweepForSmallCloudsAndFewQueries)
{
  const Points cloud = randomPoints(20000, 13, {50, 50, 0.2});
  const Points small(cloud.begin(), cloud.begin() + 900),
      some(cloud.begin(), cloud.begin() + 300), few(cloud.begin(), cloud.begin() + 100);
  const auto chosen = [](const Points& surface, const Points& queries, double radius) {
    return linelet::chosenScaleEngine(surface, queries, radius, {});
  };
  EXPECT_EQ(chosen(cloud, cloud, 5), ScaleEngine::Grid);
  EXPECT_EQ(chosen(cloud, cloud, 0.5), ScaleEngine::Grid);
  EXPECT_EQ(chosen(small, small, 5), ScaleEngine::Sweep);
  EXPECT_EQ(chosen(cloud, few, 5), ScaleEngine::Sweep);
  // A subset of the queries: the grid pays where neighborhoods are large.
  EXPECT_EQ(chosen(cloud, some, 0.5), ScaleEngine::Sweep);
  EXPECT_EQ(chosen(cloud, some, 20), ScaleEngine::Grid);
  MultiScaleSettings settings;
  settings.engine = ScaleEngine::Sweep;
  EXPECT_EQ(linelet::chosenScaleEngine(cloud, cloud, 5, settings), ScaleEngine::Sweep);
}

TEST(MultiScaleEngines, SummaryAgreesWithTheGraph)
{
  const Points cloud = randomPoints(400, 9, {10, 1, 1});
  MultiScaleShapes result;
  const auto graphs = graphsOf(cloud, cloud, {}, &result);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const MultiScaleShape& shape = result.shapes[i];
    ASSERT_GE(shape.scale, 0);
    const auto& best = graphs[i][static_cast<std::size_t>(shape.scale)];
    EXPECT_EQ(shape.linearity, best.linearity);
    EXPECT_EQ(shape.planarity, best.planarity);
    EXPECT_EQ(shape.sphericity, best.sphericity);
    EXPECT_EQ(shape.major_z, best.major_z);
    EXPECT_EQ(shape.neighbors, best.neighbors);
    float largest = 0, least = 1;
    for (const auto& scale : graphs[i])
      if (!std::isnan(scale.linearity)) {
        largest = std::max(largest, scale.linearity);
        least = std::min(least, scale.sphericity);
      }
    EXPECT_EQ(shape.linearity_max, largest);
    EXPECT_EQ(shape.min_sphericity, least);
  }
}

TEST(MultiScaleEngines, FarFromTheOriginNothingChanges)
{
  const Points cloud = randomPoints(300, 4, {3, 1, 0.1});
  Points moved = cloud;
  for (Point& point : moved)
    point += Point(65536, -131072, 4096); // exact in double, though coordinates are not
  const MultiScaleShapes here = multiScaleShapes(cloud, cloud, {});
  const MultiScaleShapes there = multiScaleShapes(moved, moved, {});
  ASSERT_EQ(here.radii.size(), there.radii.size());
  for (std::size_t i = 0; i < cloud.size(); ++i)
    EXPECT_NEAR(here.shapes[i].linearity_max, there.shapes[i].linearity_max, 1e-5);
}

} // namespace
