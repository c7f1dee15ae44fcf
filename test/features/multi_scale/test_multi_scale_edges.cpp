// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <limits>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include <linelet/features/multi_scale.h>

#include "multi_scale_clouds.h"

namespace {

using linelet::Centroid;
using linelet::Kernel;
using linelet::MultiScaleSettings;
using linelet::MultiScaleShapes;
using linelet::multiScaleShapes;
using linelet::Point;
using linelet::Points;
using linelet_test::nan;
using linelet_test::randomPoints;

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

TEST(MultiScale, CoincidentNeighborsAwayFromTheQuery)
{
  // Seen from the query they form a direction; seen from their mean there is none.
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
  // Extent 3: from radius 3 sqrt(2) on, each neighborhood is the whole cloud, and with
  // const weights nothing changes anymore.
  const Points cloud = randomPoints(200, 6, {3, 3, 0});
  MultiScaleSettings settings;
  settings.weighting = Kernel::Const;
  settings.centroid = Centroid::Mean;
  settings.radii = {0.3, 0.6, 1.2, 2.4, 4.8, 9.6, 19.2};
  settings.stop_change = 1e-9;
  MultiScaleShapes result = multiScaleShapes(cloud, cloud, settings);
  EXPECT_EQ(result.radii.back(), 9.6);
  settings.stop_change = 2; // no factor changes that much once there are factors
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

class Stopper : public linelet::ProgressMonitor {
public:
  bool
  canceled() const override
  {
    return true;
  }
};

TEST(MultiScale, CanBeCanceled)
{
  Stopper stopper;
  const Points cloud = randomPoints(300, 8);
  EXPECT_THROW(multiScaleShapes(cloud, cloud, {}, {}, &stopper), linelet::Canceled);
}

} // namespace
