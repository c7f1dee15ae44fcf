// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

#include <linelet/features/centroid_shift.h>

namespace {

using linelet::Centroid;
using linelet::CentroidShiftSettings;
using linelet::Point;
using linelet::Points;
using linelet::shiftToCentroids;

double
uniform(std::mt19937& engine)
{
  return static_cast<double>(engine()) / 4294967296.0;
}

TEST(CentroidShift, MovesToTheMeanOfUnmovedNeighbors)
{
  const Points points = {{0, 0, 0}, {1, 0, 0}, {1.5, 0.3, 0}, {9, 9, 9}};
  CentroidShiftSettings settings;
  settings.radius = 1; // the rule is d <= radius
  const Points moved = shiftToCentroids(points, settings);
  EXPECT_LT((moved[0] - Point(0.5, 0, 0)).norm(), 1e-14);
  EXPECT_LT((moved[1] - Point(2.5, 0.3, 0) / 3).norm(), 1e-14);
  EXPECT_LT((moved[2] - Point(1.25, 0.15, 0)).norm(), 1e-14);
  EXPECT_EQ(moved[3], points[3]);
}

TEST(CentroidShift, ThinsOutNoiseAcrossALine)
{
  std::mt19937 engine(2);
  Points points;
  for (int i = 0; i < 2000; ++i) {
    const double y = uniform(engine) - 0.5, z = uniform(engine) - 0.5;
    points.emplace_back(0.01 * i, 0.4 * y, 0.4 * z);
  }
  const auto width = [](const Points& cloud) {
    double sum = 0;
    for (const Point& point : cloud)
      sum += std::hypot(point.y(), point.z());
    return sum / static_cast<double>(cloud.size());
  };
  CentroidShiftSettings settings;
  settings.radius = 0.5;
  for (const Centroid centroid : {Centroid::Mean, Centroid::Median}) {
    settings.centroid = centroid;
    EXPECT_LT(width(shiftToCentroids(points, settings)), 0.35 * width(points));
  }
  // Near neighbors count most in the weighted mean, so it moves the points less.
  settings.centroid = Centroid::WeightedMean;
  EXPECT_LT(width(shiftToCentroids(points, settings)), 0.7 * width(points));
}

TEST(CentroidShift, DegenerateInput)
{
  CentroidShiftSettings settings;
  settings.radius = 1;
  EXPECT_TRUE(shiftToCentroids({}, settings).empty());
  const Point alone(1, 2, 3);
  EXPECT_EQ(shiftToCentroids({alone}, settings)[0], alone);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Points moved = shiftToCentroids({Point(nan, 0, 0), alone}, settings);
  EXPECT_TRUE(std::isnan(moved[0].x()));
  EXPECT_EQ(moved[1], alone);
  for (const double radius :
       {0.0, -1.0, nan, std::numeric_limits<double>::infinity()}) {
    settings.radius = radius;
    EXPECT_THROW(shiftToCentroids({alone}, settings), std::invalid_argument);
  }
}

TEST(CentroidShift, SameForAnyNumberOfThreads)
{
  std::mt19937 engine(3);
  Points points;
  for (int i = 0; i < 3000; ++i) {
    const double x = uniform(engine), y = uniform(engine);
    points.emplace_back(x, y, uniform(engine));
  }
  CentroidShiftSettings settings;
  settings.radius = 0.1;
  settings.threads = 1;
  const Points one = shiftToCentroids(points, settings);
  settings.threads = 4;
  EXPECT_EQ(shiftToCentroids(points, settings), one);
}

} // namespace
