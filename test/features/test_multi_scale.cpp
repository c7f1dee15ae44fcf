// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <linelet/features/multi_scale.h>

namespace {

using linelet::Centroid;
using linelet::Kernel;
using linelet::MultiScaleSettings;
using linelet::MultiScaleShape;
using linelet::MultiScaleShapes;
using linelet::multiScaleShapes;
using linelet::Point;
using linelet::Points;
using linelet::ShapeGraph;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

double
uniform(std::mt19937& engine)
{
  return static_cast<double>(engine()) / 4294967296.0;
}

Points
randomPoints(std::size_t count, unsigned seed, const Point& size = {1, 1, 1})
{
  std::mt19937 engine(seed);
  Points points;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = uniform(engine), y = uniform(engine), z = uniform(engine);
    points.push_back(Point(x, y, z).cwiseProduct(size));
  }
  return points;
}

/// Points at \a step from \a from on towards \a to, both ends included.
void
addSegment(Points& points, const Point& from, const Point& to, double step)
{
  const int steps = static_cast<int>(std::lround((to - from).norm() / step));
  for (int i = 0; i <= steps; ++i)
    points.push_back(from + (to - from) * (static_cast<double>(i) / steps));
}

std::vector<ShapeGraph>
graphsOf(const Points& surface,
         const Points& queries,
         const MultiScaleSettings& settings,
         MultiScaleShapes* result = nullptr)
{
  std::vector<ShapeGraph> graphs;
  const MultiScaleShapes shapes = multiScaleShapes(
      surface, queries, settings, [&](std::size_t query, const ShapeGraph& graph) {
        EXPECT_EQ(query, graphs.size()); // in order
        graphs.push_back(graph);
      });
  EXPECT_EQ(graphs.size(), queries.size());
  if (result != nullptr)
    *result = shapes;
  return graphs;
}

/// Linearity, planarity, sphericity by the definition, all neighbours looked at.
Eigen::Vector3d
bruteFactors(const Points& surface,
             const Point& query,
             double radius,
             Centroid centroid,
             bool fermi_dirac,
             std::uint32_t& count)
{
  Points near;
  for (const Point& point : surface)
    if ((point - query).squaredNorm() <= radius * radius)
      near.push_back(point);
  count = static_cast<std::uint32_t>(near.size());
  Point c = query;
  if (centroid == Centroid::Mean || centroid == Centroid::WeightedMean) {
    Point sum = Point::Zero();
    double total = 0;
    for (const Point& point : near) {
      const double x = (point - query).norm() / radius;
      const double w =
          centroid == Centroid::Mean ? 1 : std::min(1.0, 0.01 / (x * x + 1e-300));
      sum += w * point;
      total += w;
    }
    c = sum / total;
  }
  Eigen::Matrix3d tensor = Eigen::Matrix3d::Zero();
  double total = 0;
  for (const Point& point : near) {
    const Point v = point - c;
    const double w =
        fermi_dirac ? 1 / (std::exp((v.norm() / radius - 0.6) / 0.1) + 1) : 1;
    tensor += w * v * v.transpose();
    total += w;
  }
  const Eigen::Vector3d l =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(tensor / total).eigenvalues();
  return Eigen::Vector3d(l[2] - l[1], 2 * (l[1] - l[0]), 3 * l[0]) / l.sum();
}

TEST(MultiScale, FactorsAreThoseOfTheDefinition)
{
  for (const unsigned seed : {1u, 2u, 3u}) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Points cloud = randomPoints(300, seed, {4, 2, 1});
    const Points queries(cloud.begin(), cloud.begin() + 40);
    for (const Centroid centroid :
         {Centroid::QueryPoint, Centroid::Mean, Centroid::WeightedMean})
      for (const bool fermi_dirac : {true, false}) {
        MultiScaleSettings settings;
        settings.centroid = centroid;
        if (!fermi_dirac)
          settings.weighting = Kernel::Const;
        MultiScaleShapes result;
        const auto graphs = graphsOf(cloud, queries, settings, &result);
        for (std::size_t i = 0; i < queries.size(); ++i)
          for (std::size_t k = 0; k < result.radii.size(); ++k) {
            std::uint32_t count = 0;
            const Eigen::Vector3d expected = bruteFactors(
                cloud, queries[i], result.radii[k], centroid, fermi_dirac, count);
            ASSERT_EQ(graphs[i][k].neighbors, count);
            if (count < 3) {
              ASSERT_TRUE(std::isnan(graphs[i][k].linearity));
              continue;
            }
            ASSERT_NEAR(graphs[i][k].linearity, expected[0], 1e-6);
            ASSERT_NEAR(graphs[i][k].planarity, expected[1], 1e-6);
            ASSERT_NEAR(graphs[i][k].sphericity, expected[2], 1e-6);
          }
      }
  }
}

TEST(MultiScale, RadiiGrowFromTheScaleUnit)
{
  // Even line: the 6th nearest other point is 3 steps away.
  Points line;
  addSegment(line, {0, 0, 0}, {100, 0, 0}, 0.5);
  MultiScaleSettings settings;
  MultiScaleShapes result = multiScaleShapes(line, {}, settings);
  EXPECT_NEAR(result.scale_unit, 1.5, 1e-12);
  ASSERT_EQ(result.radii.size(), 11u); // 1.5^10 = 57.7 <= 60 < 1.5^11
  for (std::size_t k = 0; k < result.radii.size(); ++k)
    EXPECT_NEAR(result.radii[k], 1.5 * std::pow(1.5, k), 1e-9);
  settings.growth = linelet::RadiusGrowth::Linear;
  settings.max_radius = 7.5; // a multiple of D: rounding must not lose it
  result = multiScaleShapes(line, {}, settings);
  ASSERT_EQ(result.radii.size(), 5u);
  EXPECT_NEAR(result.radii[4], 7.5, 1e-12);
  settings.radii = {0.3, 1, 20};
  EXPECT_EQ(multiScaleShapes(line, {}, settings).radii, settings.radii);
}

TEST(MultiScale, MiddleOfALine)
{
  Points line;
  addSegment(line, {-10, -10, -10}, {10, 10, 10}, 0.1);
  const std::size_t middle = line.size() / 2;
  const MultiScaleShapes result = multiScaleShapes(line, line, {});
  const MultiScaleShape& shape = result.shapes[middle];
  EXPECT_NEAR(shape.linearity, 1, 1e-6);
  EXPECT_NEAR(shape.linearity_max, 1, 1e-6);
  EXPECT_NEAR(shape.linearity_sum, static_cast<double>(result.radii.size()), 1e-4);
  EXPECT_NEAR(shape.min_sphericity, 0, 1e-6);
  // A plateau: the smallest scale with 7 points.
  EXPECT_EQ(shape.scale, 0);
  EXPECT_EQ(shape.neighbors, 7u);
  EXPECT_EQ(shape.first_neighbors, 6u);
  EXPECT_NEAR(shape.optimal_radius, result.scale_unit, 1e-6);
  EXPECT_NEAR(shape.blend, 0.95, 1e-6);
  const double c = 1 / std::sqrt(3.0);
  EXPECT_NEAR(shape.major_x, c, 1e-6);
  EXPECT_NEAR(shape.major_y, c, 1e-6);
  EXPECT_NEAR(shape.major_z, c, 1e-6);
}

TEST(MultiScale, LinearityFallsWhereTheRadiusReachesACorner)
{
  Points cloud;
  addSegment(cloud, {-20, 0, 0}, {0, 0, 0}, 0.1);
  addSegment(cloud, {0, 0.1, 0}, {0, 20, 0}, 0.1);
  MultiScaleSettings settings;
  for (int k = 1; k <= 40; ++k)
    settings.radii.push_back(0.45 * k);
  for (const double distance : {2.0, 5.0}) {
    const auto graph = graphsOf(cloud, {Point(-distance, 0, 0)}, settings)[0];
    for (std::size_t k = 0; k < graph.size(); ++k) {
      if (settings.radii[k] < distance) {
        EXPECT_NEAR(graph[k].linearity, 1, 1e-6) << settings.radii[k];
      }
      else if (settings.radii[k] > distance + 0.1) {
        EXPECT_LT(graph[k].linearity, 1) << settings.radii[k];
      }
    }
  }
}

TEST(MultiScale, Crossings)
{
  Points cross;
  addSegment(cross, {-10, 0, 0}, {10, 0, 0}, 0.1);
  addSegment(cross, {0, -10, 0}, {0, 10, 0}, 0.1);
  MultiScaleSettings settings;
  settings.radii = {0.5, 1, 2, 4, 8};
  const ShapeGraph flat = graphsOf(cross, {Point(0, 0, 0)}, settings)[0];
  for (const auto& shape : flat)
    EXPECT_NEAR(shape.planarity, 1, 1e-6);
  addSegment(cross, {0, 0, -10}, {0, 0, 10}, 0.1);
  const ShapeGraph round = graphsOf(cross, {Point(0, 0, 0)}, settings)[0];
  for (const auto& shape : round)
    EXPECT_NEAR(shape.sphericity, 1, 1e-6);
  // On an arm, the linearity falls where the radius reaches the other arms.
  const auto arm = graphsOf(cross, {Point(5, 0, 0)}, settings)[0];
  EXPECT_NEAR(arm[3].linearity, 1, 1e-6);
  EXPECT_LT(arm[4].linearity, 1);
}

TEST(MultiScale, MinimumLiesAtTheSizeOfTheJitter)
{
  // A line of samples displaced by one distance in random directions: within that
  // distance a neighbourhood is a blob, beyond it a line.
  const unsigned seed = 5;
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 engine(seed);
  for (const double jitter : {0.2, 0.4, 0.8}) {
    Points cloud;
    addSegment(cloud, {-20, 0, 0}, {20, 0, 0}, jitter / 50);
    for (Point& point : cloud) {
      Point way;
      do
        way = Point(uniform(engine), uniform(engine), uniform(engine)) * 2 -
              Point::Ones();
      while (way.norm() > 1 || way.norm() < 0.1);
      point += jitter * way.normalized();
    }
    MultiScaleSettings settings;
    for (int k = 1; k <= 60; ++k)
      settings.radii.push_back(jitter * 0.1 * k);
    Points queries;
    for (std::size_t i = 0; i < cloud.size(); i += 7)
      if (std::abs(cloud[i].x()) < 12)
        queries.push_back(cloud[i]);
    std::vector<double> mean(settings.radii.size(), 0.0);
    for (const ShapeGraph& graph : graphsOf(cloud, queries, settings))
      for (std::size_t k = 0; k < graph.size(); ++k)
        if (!std::isnan(graph[k].linearity))
          mean[k] += static_cast<double>(graph[k].linearity) /
                     static_cast<double>(queries.size());
    const auto lowest = std::min_element(mean.begin() + 5, mean.end()) - mean.begin();
    const double radius = settings.radii[static_cast<std::size_t>(lowest)];
    EXPECT_GT(radius, 0.7 * jitter);
    EXPECT_LT(radius, 2.5 * jitter);
    EXPECT_GT(mean.back(), mean[static_cast<std::size_t>(lowest)] + 0.2);
  }
}

TEST(MultiScale, SameForAnyNumberOfThreads)
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
  // Listening to the graphs changes nothing.
  const MultiScaleShapes silent = multiScaleShapes(cloud, cloud, settings);
  for (std::size_t i = 0; i < cloud.size(); ++i)
    ASSERT_EQ(silent.shapes[i].optimal_radius, one.shapes[i].optimal_radius);
}

TEST(MultiScale, GridEngineAgreesWithTheSweep)
{
  Points cloud = randomPoints(3000, 12, {10, 10, 0.5});
  cloud.push_back(cloud[5]); // a coincident pair
  const Points queries(cloud.begin(), cloud.begin() + 300);
  for (const Centroid centroid : {Centroid::QueryPoint, Centroid::WeightedMean}) {
    MultiScaleSettings settings;
    settings.centroid = centroid;
    settings.max_radius = 6;
    MultiScaleShapes sweep, grid;
    settings.engine = linelet::ScaleEngine::Sweep;
    const auto graphs_of_sweep = graphsOf(cloud, queries, settings, &sweep);
    settings.engine = linelet::ScaleEngine::Grid;
    const auto graphs_of_grid = graphsOf(cloud, queries, settings, &grid);
    ASSERT_EQ(sweep.radii, grid.radii);
    for (std::size_t i = 0; i < queries.size(); ++i) {
      ASSERT_EQ(sweep.shapes[i].first_neighbors, grid.shapes[i].first_neighbors);
      ASSERT_NEAR(sweep.shapes[i].linearity_sum, grid.shapes[i].linearity_sum, 2e-3);
      ASSERT_NEAR(sweep.shapes[i].min_sphericity, grid.shapes[i].min_sphericity, 2e-4);
      for (std::size_t k = 0; k < sweep.radii.size(); ++k) {
        const auto &a = graphs_of_sweep[i][k], &b = graphs_of_grid[i][k];
        ASSERT_EQ(a.neighbors, b.neighbors);
        ASSERT_EQ(std::isnan(a.linearity), std::isnan(b.linearity));
        if (std::isnan(a.linearity))
          continue;
        ASSERT_NEAR(a.linearity, b.linearity, 2e-4);
        ASSERT_NEAR(a.planarity, b.planarity, 2e-4);
        ASSERT_NEAR(a.sphericity, b.sphericity, 2e-4);
        if (a.linearity > 0.1F) {
          const float dot =
              a.major_x * b.major_x + a.major_y * b.major_y + a.major_z * b.major_z;
          ASSERT_NEAR(std::abs(dot), 1, 1e-4);
        }
      }
    }
  }
}

TEST(MultiScale, AutoTakesTheGridWhereNeighbourhoodsAreLarge)
{
  // Told apart by what only one of them does: both must then be equal to the last bit.
  const Points cloud = randomPoints(3000, 13, {5, 5, 0.2});
  const auto linearities = [&](linelet::ScaleEngine engine, double max_radius) {
    MultiScaleSettings settings;
    settings.engine = engine;
    settings.max_radius = max_radius;
    std::vector<float> values;
    for (const MultiScaleShape& shape : multiScaleShapes(cloud, cloud, settings).shapes)
      values.push_back(shape.linearity_sum);
    return values;
  };
  using linelet::ScaleEngine;
  EXPECT_EQ(linearities(ScaleEngine::Auto, 5), linearities(ScaleEngine::Grid, 5));
  EXPECT_EQ(linearities(ScaleEngine::Auto, 0.5), linearities(ScaleEngine::Sweep, 0.5));
}

TEST(MultiScale, SummaryAgreesWithTheGraph)
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

TEST(MultiScale, FarFromTheOriginNothingChanges)
{
  const Points cloud = randomPoints(300, 4, {3, 1, 0.1});
  Points moved = cloud;
  for (Point& point : moved)
    point += Point(65536, -131072, 4096); // exact in double, coordinates are not
  const MultiScaleShapes here = multiScaleShapes(cloud, cloud, {});
  const MultiScaleShapes there = multiScaleShapes(moved, moved, {});
  ASSERT_EQ(here.radii.size(), there.radii.size());
  for (std::size_t i = 0; i < cloud.size(); ++i)
    EXPECT_NEAR(here.shapes[i].linearity_max, there.shapes[i].linearity_max, 1e-5);
}

TEST(MultiScale, DegenerateClouds)
{
  MultiScaleSettings settings;
  settings.radii = {1, 2, 4};
  EXPECT_TRUE(multiScaleShapes({}, {}, settings).shapes.empty());

  const auto expectUnknown = [&](const Points& surface, const Point& query) {
    for (const Centroid centroid : {Centroid::QueryPoint,
                                    Centroid::Mean,
                                    Centroid::WeightedMean,
                                    Centroid::Median,
                                    Centroid::WeightedMedian})
      for (const Kernel kernel : {Kernel::Const, Kernel::FermiDirac1, Kernel::Linear}) {
        settings.centroid = centroid;
        settings.weighting = kernel;
        const auto shape = multiScaleShapes(surface, {query}, settings).shapes[0];
        EXPECT_EQ(shape.scale, -1);
        EXPECT_TRUE(std::isnan(shape.linearity));
        EXPECT_TRUE(std::isnan(shape.optimal_radius));
        EXPECT_TRUE(std::isnan(shape.blend));
        EXPECT_TRUE(std::isnan(shape.linearity_sum));
        EXPECT_TRUE(std::isnan(shape.min_sphericity));
        EXPECT_TRUE(std::isnan(shape.major_x));
        EXPECT_EQ(shape.neighbors, 0u);
      }
  };
  expectUnknown({}, {0, 0, 0});
  expectUnknown({Point(0, 0, 0)}, {0, 0, 0});
  expectUnknown({Point(0, 0, 0), Point(0.5, 0, 0)}, {0, 0, 0});
  expectUnknown(Points(20, Point(0.3, 0.1, 7)), {0.3, 0.1, 7});
  expectUnknown(Points(20, Point(9, 9, 9)), {0, 0, 0});
  expectUnknown(randomPoints(50, 1), {nan, 0, 0});
  expectUnknown(Points(20, Point(nan, nan, nan)), {0, 0, 0});
}

TEST(MultiScale, CoincidentNeighboursAwayFromTheQuery)
{
  // Seen from the query they are a direction; seen from their mean there is nothing.
  MultiScaleSettings settings;
  settings.radii = {1};
  const Points heap(9, Point(0.1, 0.2, 0.3));
  EXPECT_NEAR(
      multiScaleShapes(heap, {Point(0, 0, 0)}, settings).shapes[0].linearity, 1, 1e-6);
  settings.centroid = Centroid::Mean;
  for (const Kernel kernel : {Kernel::Const, Kernel::FermiDirac1}) {
    settings.weighting = kernel;
    EXPECT_TRUE(std::isnan(
        multiScaleShapes(heap, {Point(0, 0, 0)}, settings).shapes[0].linearity_max));
  }
}

TEST(MultiScale, NanInTheSurfaceIsLeftOut)
{
  Points cloud = randomPoints(200, 2);
  MultiScaleSettings settings;
  settings.radii = {0.2, 0.4};
  const auto clean = multiScaleShapes(cloud, cloud, settings);
  Points dirty = cloud;
  dirty.insert(dirty.begin() + 50, Point(nan, 0, 0));
  dirty.push_back(Point(0, std::numeric_limits<double>::infinity(), 0));
  const auto result = multiScaleShapes(dirty, cloud, settings);
  for (std::size_t i = 0; i < cloud.size(); ++i)
    EXPECT_EQ(result.shapes[i].linearity_max, clean.shapes[i].linearity_max);
}

TEST(MultiScale, FirstNeighborsLeaveThePointItselfOut)
{
  const Points cloud = {{0, 0, 0}, {0, 0, 0}, {1.5, 0, 0}, {0, 1.9, 0}, {9, 0, 0}};
  MultiScaleSettings settings;
  settings.radii = {1, 2, 4};
  const auto shape = multiScaleShapes(cloud, {Point(0, 0, 0)}, settings).shapes[0];
  EXPECT_EQ(shape.first_neighbors, 2u); // none within 1, two within 2
}

TEST(MultiScale, StopRuleEndsWhereAllHaveConverged)
{
  // Extent 3: from radius 3 sqrt(2) on, each neighbourhood is the whole cloud. With
  // const weights nothing changes any more.
  const Points cloud = randomPoints(200, 6, {3, 3, 0});
  MultiScaleSettings settings;
  settings.weighting = Kernel::Const;
  settings.centroid = Centroid::Mean;
  settings.radii = {0.3, 0.6, 1.2, 2.4, 4.8, 9.6, 19.2};
  settings.stop_change = 1e-9;
  MultiScaleShapes result = multiScaleShapes(cloud, cloud, settings);
  EXPECT_EQ(result.radii.back(), 9.6);
  settings.stop_change = 2; // no factor changes that much, once there are factors
  result = multiScaleShapes(cloud, cloud, settings);
  EXPECT_LE(result.radii.back(), 0.6);
  settings.centroid = Centroid::QueryPoint;
  EXPECT_THROW(multiScaleShapes(cloud, cloud, settings), std::invalid_argument);
}

TEST(MultiScale, RefusesParametersThatMakeNoSense)
{
  const Points cloud = randomPoints(50, 3);
  const auto refuses = [&](const MultiScaleSettings& settings, const Points& points) {
    EXPECT_THROW(multiScaleShapes(points, points, settings), std::invalid_argument);
  };
  for (const auto& radii : {std::vector<double>{0},
                            std::vector<double>{-1, 1},
                            std::vector<double>{1, 1},
                            std::vector<double>{2, 1},
                            std::vector<double>{nan},
                            std::vector<double>(5000, 1.0)}) {
    MultiScaleSettings settings;
    settings.radii = radii;
    refuses(settings, cloud);
  }
  for (const double bad : {-1.0, nan, std::numeric_limits<double>::infinity()}) {
    MultiScaleSettings settings;
    settings.max_radius = bad;
    refuses(settings, cloud);
    settings = {};
    settings.scale_unit = bad;
    refuses(settings, cloud);
    settings = {};
    settings.stop_change = bad;
    settings.centroid = Centroid::Mean;
    refuses(settings, cloud);
  }
  MultiScaleSettings small;
  small.max_radius = 1e-9; // less than D
  refuses(small, cloud);
  // No scale unit: one point, all in one place, nothing finite.
  refuses({}, {Point(0, 0, 0)});
  refuses({}, Points(10, Point(1, 1, 1)));
  refuses({}, Points(10, Point(nan, 1, 1)));
}

class Stopper : public linelet::Monitor {
public:
  bool
  cancelled() const override
  {
    return true;
  }
};

TEST(MultiScale, CanBeCancelled)
{
  Stopper stopper;
  const Points cloud = randomPoints(300, 8);
  EXPECT_THROW(multiScaleShapes(cloud, cloud, {}, {}, &stopper), linelet::Cancelled);
}

} // namespace
