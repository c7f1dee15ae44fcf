// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <atomic>
#include <cmath>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "features/tensor_reference.h"

using namespace linelet;
using namespace linelet::test;
TEST(TensorEstimation, DoesNotMoveWithTheCloud)
{
  // Multiples of 1/256 plus these offsets are exact in double, so every bit must agree.
  const Points points = scene(500, 6);
  Points moved;
  for (const Point& point : points)
    moved.push_back(point + Point(5e5, 5.5e6, 64));
  for (const auto& [centroid, name] : Names<Centroid>::table) {
    for (const Engine engine : {Engine::Grid, Engine::Tree}) {
      SCOPED_TRACE(std::string(name) + " " + std::string(nameOf(engine)));
      TensorSettings settings = withRadius(1, Kernel::FermiDirac1, centroid);
      settings.engine = engine;
      const Records here = estimateTensors(points, points, settings);
      const Records there = estimateTensors(moved, moved, settings);
      for (std::size_t i = 0; i < here.size(); ++i) {
        EXPECT_EQ(here[i].neighbors, there[i].neighbors);
        EXPECT_LE(shapeDifference(here[i], shapeOf(there[i])), 1e-6) << "query " << i;
      }
    }
  }
}

TEST(TensorEstimation, ScalesWithTheSquareAndTurnsWithTheCloud)
{
  const Points points = scene(500, 7);
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(1.1, Point(3, -1, 2).normalized()).toRotationMatrix();
  Points scaled, turned;
  for (const Point& point : points) {
    scaled.push_back(8 * point);
    turned.push_back(turn * point);
  }
  for (const auto& [centroid, name] : Names<Centroid>::table) {
    SCOPED_TRACE(std::string(name));
    // No point is so close to this radius that the rotation could move it across.
    TensorSettings settings = withRadius(1.0012345, Kernel::FermiDirac1, centroid);
    const Records original = estimateTensors(points, points, settings);
    const Records after = estimateTensors(turned, turned, settings);
    settings.radius *= 8;
    const Records large = estimateTensors(scaled, scaled, settings);
    for (std::size_t i = 0; i < points.size(); ++i) {
      ASSERT_EQ(original[i].neighbors, large[i].neighbors);
      ASSERT_EQ(std::isnan(original[i].lambda3), std::isnan(large[i].lambda3));
      if (std::isnan(original[i].lambda3))
        continue;
      EXPECT_FLOAT_EQ(64 * original[i].lambda3, large[i].lambda3);
      EXPECT_FLOAT_EQ(original[i].sphericity, large[i].sphericity);
      ASSERT_EQ(original[i].neighbors, after[i].neighbors);
      EXPECT_LE(shapeDifference(original[i], shapeOf(after[i])), 1e-5) << "query " << i;
      if (original[i].linearity > 0.1) {
        EXPECT_NEAR(
            std::abs((turn * majorOf(original[i])).dot(majorOf(after[i]))), 1, 1e-5);
      }
    }
  }
}

TEST(TensorEstimation, GivesTheSameBitsForAnyNumberOfThreads)
{
  const Points points = scene(3000, 8);
  for (const Engine engine : {Engine::Grid, Engine::Tree}) {
    TensorSettings settings = withRadius(0.7, Kernel::Cubic, Centroid::Median);
    settings.engine = engine;
    settings.threads = 1;
    const Records serial = estimateTensors(points, points, settings);
    for (const unsigned threads : {2u, 5u, 0u}) {
      settings.threads = threads;
      EXPECT_TRUE(sameBits(serial, estimateTensors(points, points, settings)));
    }
  }
}

TEST(TensorEstimation, ByKTakesTheNearestAndTheirReachAsRadius)
{
  const Points points = scene(400, 9);
  for (const Engine engine : {Engine::Auto, Engine::Grid, Engine::Tree}) {
    TensorSettings by_k;
    by_k.k = 12;
    by_k.engine = engine;
    const Records records = estimateTensors(points, points, by_k);
    for (std::size_t i = 0; i < points.size(); ++i) {
      std::vector<double> distances;
      for (const Point& point : points)
        distances.push_back((point - points[i]).norm());
      std::sort(distances.begin(), distances.end());
      ASSERT_EQ(records[i].neighbors, 12u);
      if (distances[11] == distances[12])
        continue; // another point at the same distance, which a radius cannot separate
      EXPECT_LE(
          shapeDifference(
              records[i],
              bruteForce(points, points[i], withRadius(distances[11] * (1 + 1e-12)))
                  .shape),
          1e-5);
    }
  }
  TensorSettings all;
  all.k = 1000;
  EXPECT_EQ(estimateTensors(points, points, all).front().neighbors, 400u);
}

TEST(TensorEstimation, TakesSizesPointByPoint)
{
  const Points points = scene(400, 10);
  NeighborhoodSizes sizes;
  for (std::size_t i = 0; i < points.size(); ++i)
    sizes.radii.push_back(0.5 + 0.01 * static_cast<double>(i % 100));
  sizes.radii[3] = not_known;
  sizes.radii[4] = 0;
  sizes.radii[5] = -1;
  sizes.radii[6] = infinite;
  for (const Engine engine : {Engine::Grid, Engine::Tree}) {
    TensorSettings settings;
    settings.engine = engine;
    const Records records = estimateTensors(points, points, settings, sizes);
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (i >= 3 && i <= 6) {
        EXPECT_TRUE(std::isnan(records[i].linearity));
        EXPECT_EQ(records[i].neighbors, 0u);
        continue;
      }
      const Expected expected =
          bruteForce(points, points[i], withRadius(sizes.radii[i]));
      EXPECT_EQ(records[i].neighbors, expected.neighbors);
      EXPECT_LE(shapeDifference(records[i], expected.shape), 1e-5);
    }
  }

  NeighborhoodSizes counts;
  counts.counts.assign(points.size(), 9);
  counts.counts[1] = 0;
  TensorSettings nine;
  nine.k = 9;
  Records by_count = estimateTensors(points, points, {}, counts);
  EXPECT_TRUE(std::isnan(by_count[1].linearity));
  by_count[1] = estimateTensors(points, points, nine)[1];
  EXPECT_TRUE(sameBits(by_count, estimateTensors(points, points, nine)));
}

// A median mostly lies on a neighbor, whose weight would be infinite or nothing.
TEST(TensorEstimation, RefusesUnboundedWeightingsAboutOtherPlacesThanTheQuery)
{
  const Points points = scene(10, 1);
  const auto refused = [&](const TensorSettings& settings) {
    EXPECT_THROW(estimateTensors(points, points, settings), std::invalid_argument);
  };
  refused(withRadius(1, Kernel::InverseDistance, Centroid::Mean));
  refused(withRadius(1, Kernel::InverseSquaredDistance, Centroid::Median));
  TensorSettings settings = withRadius(1, Kernel::Const, Centroid::WeightedMedian);
  settings.centroid_weighting = Kernel::InverseDistance;
  refused(settings);
  settings.centroid = Centroid::WeightedMean;
  EXPECT_NO_THROW(estimateTensors(points, points, settings));
}

TEST(TensorEstimation, RefusesSizesThatMakeNoSense)
{
  const Points points = scene(10, 1);
  TensorSettings none, both = withRadius(1);
  both.k = 5;
  NeighborhoodSizes few;
  few.radii = {1, 2};
  EXPECT_THROW(estimateTensors(points, points, none), std::invalid_argument);
  EXPECT_THROW(estimateTensors(points, points, both), std::invalid_argument);
  EXPECT_THROW(estimateTensors(points, points, none, few), std::invalid_argument);
  EXPECT_THROW(estimateTensors(points, {points[0], points[1]}, withRadius(1), few),
               std::invalid_argument);
  for (const double radius : {-1.0, infinite, not_known}) {
    try {
      estimateTensors(points, points, withRadius(radius));
      ADD_FAILURE() << radius;
    }
    catch (const std::invalid_argument& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr("not a positive finite number"));
    }
  }
}

namespace {

class Counter : public ProgressMonitor {
public:
  explicit Counter(std::size_t end) : end_(end) {}
  void
  advance(std::size_t steps) override
  {
    done += steps;
  }
  bool
  canceled() const override
  {
    return done >= end_;
  }
  std::atomic<std::size_t> done{0};

private:
  std::size_t end_;
};

} // namespace

TEST(TensorEstimation, TellsItsProgressAndStopsWhenAsked)
{
  const Points points = scene(5000, 11);
  Counter all(points.size() + 1);
  estimateTensors(points, points, withRadius(0.2), {}, &all);
  EXPECT_EQ(all.done, points.size());
  Counter some(1000);
  EXPECT_THROW(estimateTensors(points, points, withRadius(0.2), {}, &some), Canceled);
}
