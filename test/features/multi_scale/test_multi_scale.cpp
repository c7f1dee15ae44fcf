// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <linelet/features/multi_scale.h>

#include "multi_scale_clouds.h"

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
using linelet_test::addSegment;
using linelet_test::graphsOf;
using linelet_test::randomPoints;
using linelet_test::uniform;

/// Linearity, planarity, sphericity by definition, from all neighbors.
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
  // Evenly spaced line: the 6th nearest other point is 3 steps away.
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
  // On an arm, linearity falls where the radius reaches the other arms.
  const auto arm = graphsOf(cross, {Point(5, 0, 0)}, settings)[0];
  EXPECT_NEAR(arm[3].linearity, 1, 1e-6);
  EXPECT_LT(arm[4].linearity, 1);
}

TEST(MultiScale, MinimumLiesAtTheSizeOfTheJitter)
{
  // A line of samples displaced by a fixed distance in random directions: up to that
  // distance a neighborhood is a blob, beyond it a line.
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

} // namespace
