// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "features/tensor_reference.h"

using namespace linelet;
using namespace linelet::test;

TEST(TensorEstimation, IsTheDefinitionForEveryKernelCentroidAndEngine)
{
  const Points surface = scene(700, 1);
  Points queries = scene(12, 2); // outside the cloud
  queries.insert(queries.end(), surface.begin(), surface.begin() + 12);
  std::vector<Weighting> weightings = {Weighting::fermiDirac(0.45, 0.07),
                                       Weighting::step(0.8)};
  for (const auto& entry : Names<Kernel>::table)
    if (entry.first != Kernel::FermiDirac && entry.first != Kernel::Step)
      weightings.emplace_back(entry.first);
  for (const Weighting& weighting : weightings) {
    for (const auto& [centroid, name] : Names<Centroid>::table) {
      if (isUnbounded(weighting.kernel()) && centroid != Centroid::QueryPoint)
        continue; // refused
      TensorSettings settings = withRadius(0.9, weighting, centroid);
      std::vector<Expected> expected;
      for (const Point& query : queries)
        expected.push_back(bruteForce(surface, query, settings));
      for (const Engine engine : {Engine::Grid, Engine::Tree}) {
        SCOPED_TRACE(weighting.name() + " " + std::string(name) + " " +
                     std::string(nameOf(engine)));
        settings.engine = engine;
        const Records records = estimateTensors(surface, queries, settings);
        for (std::size_t i = 0; i < queries.size(); ++i) {
          EXPECT_EQ(records[i].neighbors, expected[i].neighbors);
          EXPECT_LE(shapeDifference(records[i], expected[i].shape), 1e-5)
              << "query " << i;
        }
      }
    }
  }
}

// Both engines, and all ways in which the grid sums: moments, kernels, around a mean,
// in double.
TEST(TensorEstimation, DividedByTheCountIsScaledByTheMeanWeight)
{
  const Points surface = scene(700, 4);
  const Points queries(surface.begin(), surface.begin() + 40);
  for (const char* weighting : {"const", "sph-4", "epanechnikov", "step:0.8"})
    for (const Centroid centroid : {Centroid::QueryPoint, Centroid::WeightedMean})
      for (const Engine engine : {Engine::Grid, Engine::Tree}) {
        SCOPED_TRACE(std::string(weighting) + " " + std::string(nameOf(centroid)) +
                     " " + std::string(nameOf(engine)));
        TensorSettings settings = withRadius(0.9, weighting, centroid);
        settings.engine = engine;
        const Records by_weight = estimateTensors(surface, queries, settings);
        settings.normalization = Normalization::Count;
        const Records by_count = estimateTensors(surface, queries, settings);
        for (std::size_t i = 0; i < queries.size(); ++i) {
          Point c = Point::Zero();
          Points found;
          for (const Point& point : surface)
            if ((point - queries[i]).squaredNorm() <= 0.9 * 0.9)
              found.push_back(point - queries[i]);
          if (centroid == Centroid::WeightedMean)
            c = linelet::centroid(
                centroid, found, Point::Zero(), 0.9, settings.centroid_weighting);
          double mean = 0;
          for (const Point& point : found)
            mean += settings.weighting((point - c).norm() / 0.9);
          mean /= static_cast<double>(found.size());
          if (std::isnan(by_weight[i].xx))
            continue;
          const float scale = std::max(by_weight[i].lambda3, 1e-3F);
          EXPECT_NEAR(by_count[i].xy, mean * by_weight[i].xy, 1e-4 * mean * scale);
          EXPECT_NEAR(
              by_count[i].lambda3, mean * by_weight[i].lambda3, 1e-4 * mean * scale);
          EXPECT_NEAR(by_count[i].linearity, by_weight[i].linearity, 1e-4);
        }
      }
}

TEST(TensorEstimation, WeightedCentroidsOfEveryWeightingAreTheDefinition)
{
  const Points surface = scene(700, 3);
  const Points queries(surface.begin(), surface.begin() + 15);
  for (const char* weighting :
       {"const", "linear", "quadratic-inverse", "fermi-dirac-2", "sph-4"}) {
    for (const Centroid centroid : {Centroid::WeightedMean, Centroid::WeightedMedian}) {
      SCOPED_TRACE(std::string(weighting) + " " + std::string(nameOf(centroid)));
      TensorSettings settings = withRadius(1.1, Kernel::Const, centroid);
      settings.centroid_weighting = weighting;
      const Records records = estimateTensors(surface, queries, settings);
      for (std::size_t i = 0; i < queries.size(); ++i)
        EXPECT_LE(shapeDifference(records[i],
                                  bruteForce(surface, queries[i], settings).shape),
                  1e-5)
            << "query " << i;
    }
  }
}

TEST(TensorEstimation, OfALine)
{
  const Point direction = Point(1, 2, -2) / 3;
  Points line;
  for (int i = -50; i <= 50; ++i)
    line.push_back(0.25 * i * direction);
  const PointDistributionTensor record =
      tensorAt(line, Point::Zero(), withRadius(1.1, Kernel::Const));
  EXPECT_EQ(record.neighbors, 9u); // steps -4 .. 4
  EXPECT_FLOAT_EQ(record.linearity, 1);
  EXPECT_NEAR(record.planarity, 0, 1e-7);
  EXPECT_NEAR(record.sphericity, 0, 1e-7);
  EXPECT_FLOAT_EQ(record.lambda3, 2 * (1 + 4 + 9 + 16) * 0.0625f / 9);
  EXPECT_NEAR(std::abs(majorOf(record).dot(direction)), 1, 1e-6);
  // v (x) v / |v|^2 of a line is its direction (x) direction.
  EXPECT_NEAR(record.xy / record.lambda3, direction.x() * direction.y(), 1e-6);
  EXPECT_NEAR(record.zz / record.lambda3, direction.z() * direction.z(), 1e-6);
}

TEST(TensorEstimation, OfAPlaneAndABall)
{
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(0.7, Point(1, 2, 3).normalized()).toRotationMatrix();
  Points plane, ball;
  for (int x = -8; x <= 8; ++x)
    for (int y = -8; y <= 8; ++y) {
      plane.push_back(turn * Point(x, y, 0));
      for (int z = -8; z <= 8; ++z)
        ball.push_back(turn * Point(x, y, z));
    }
  for (const auto& [centroid, name] : Names<Centroid>::table) {
    SCOPED_TRACE(std::string(name));
    const TensorSettings settings = withRadius(6.5, Kernel::FermiDirac1, centroid);
    const PointDistributionTensor flat = tensorAt(plane, Point::Zero(), settings);
    EXPECT_NEAR(flat.planarity, 1, 1e-6);
    EXPECT_NEAR(std::abs(normalOf(flat).dot(turn.col(2))), 1, 1e-6);
    const PointDistributionTensor round = tensorAt(ball, Point::Zero(), settings);
    EXPECT_NEAR(round.sphericity, 1, 1e-6);
  }
}

TEST(TensorEstimation, OfAHelixFollowsTheTangent)
{
  Points helix;
  for (int i = 0; i <= 4000; ++i) {
    const double t = 0.001 * i * 12.566370614359172;
    helix.emplace_back(3 * std::cos(t), 3 * std::sin(t), 10 * t / 12.566370614359172);
  }
  for (const int i : {1000, 2000, 2500}) {
    const double t = 0.001 * i * 12.566370614359172;
    const Point tangent =
        Point(-3 * std::sin(t), 3 * std::cos(t), 10 / 12.566370614359172).normalized();
    const PointDistributionTensor record =
        tensorAt(helix, helix[static_cast<std::size_t>(i)], withRadius(0.3));
    EXPECT_GT(record.linearity, 0.99);
    EXPECT_GT(std::abs(majorOf(record).dot(tangent)), 0.9999);
  }
}

TEST(TensorEstimation, IsUnknownWithoutAShape)
{
  const Point place(5e5 + 0.1, 5e6, 1);
  for (const auto& [centroid, name] : Names<Centroid>::table) {
    SCOPED_TRACE(std::string(name));
    const TensorSettings settings = withRadius(2, Kernel::FermiDirac1, centroid);
    EXPECT_TRUE(estimateTensors({place}, {}, settings).empty());
    EXPECT_EQ(tensorAt({}, place, settings).neighbors, 0u);
    EXPECT_TRUE(shapeOf(tensorAt({}, place, settings)).hasNaN());

    const PointDistributionTensor single = tensorAt({place}, place, settings);
    EXPECT_EQ(single.neighbors, 1u);
    const PointDistributionTensor coincident =
        tensorAt(Points(40, place), place, settings);
    EXPECT_EQ(coincident.neighbors, 40u);
    for (const PointDistributionTensor& record : {single, coincident}) {
      // Every float of the record, whatever its name.
      float values[18];
      std::memcpy(values, &record, sizeof(values));
      for (const float value : values)
        EXPECT_TRUE(std::isnan(value));
    }
  }
  // Seen from outside, coincident points have a direction for pdt, but none around
  // their own center, where only rounding is left.
  const Point beside = place + Point(0.3, 0.4, 0);
  EXPECT_FLOAT_EQ(tensorAt(Points(40, place), beside, withRadius(2)).linearity, 1);
  for (const Centroid centroid :
       {Centroid::Mean, Centroid::WeightedMean, Centroid::Median})
    EXPECT_TRUE(std::isnan(
        tensorAt(Points(40, place), beside, withRadius(2, Kernel::Const, centroid))
            .linearity));
}

TEST(TensorEstimation, LeavesPointsThatAreNotFiniteAside)
{
  Points surface = scene(300, 5), queries = surface;
  const Records clean = estimateTensors(surface, queries, withRadius(1));
  surface.emplace_back(not_known, 0, 0);
  surface.emplace_back(0, infinite, 0);
  queries.emplace_back(0, 0, not_known);
  for (const Engine engine : {Engine::Grid, Engine::Tree}) {
    TensorSettings settings = withRadius(1);
    settings.engine = engine;
    const Records records = estimateTensors(surface, queries, settings);
    for (std::size_t i = 0; i < clean.size(); ++i) {
      EXPECT_EQ(records[i].neighbors, clean[i].neighbors);
      EXPECT_LE(shapeDifference(records[i], shapeOf(clean[i])), 1e-6);
    }
    EXPECT_EQ(records.back().neighbors, 0u);
    EXPECT_TRUE(std::isnan(records.back().major_z));
  }
}
