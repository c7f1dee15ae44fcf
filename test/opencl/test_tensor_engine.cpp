// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <cstring>
#include <limits>
#include <string>

#include <linelet/opencl/point_distribution_tensor_ocl.h>

#include "estimation.h"
#include "opencl/tensor_engine_fixture.h"

using namespace linelet;
using namespace linelet::test;

// Each pair of centroid and weighting needs its own program, so not every pair is
// tried; Stages.WeightsAreThoseOfWeighting covers each weighting on its own.
TEST_F(OpenCL, EveryCentroidGivesWhatTheReferenceGives)
{
  const Points points = box(1500, Point(8, 6, 2), 3);
  for (const auto& centroid : Names<Centroid>::table) {
    if (centroid.first == Centroid::WeightedMedian)
      continue; // refused, see ReportsUnsupportedRequests
    SCOPED_TRACE(std::string(centroid.second));
    TensorSettings settings = withRadius(0.9, "fermi-dirac-1");
    settings.centroid = centroid.first;
    check(points, points, settings);
  }
}

TEST_F(OpenCL, WeightingsOfEveryKindGiveWhatTheReferenceGives)
{
  const Points points = box(400, Point(4, 3, 2), 4);
  for (const char* weight :
       {"const", "cubic-inverse", "sph-5", "ease-bounce", "cs-rbf-6", "step:0.45"}) {
    SCOPED_TRACE(weight);
    check(points, points, withRadius(0.9, weight));
  }
}

// By radius and by number, which are different programs.
TEST_F(OpenCL, TensorsDividedByTheCountAreThoseOfTheReference)
{
  const Points points = box(400, Point(4, 3, 2), 5);
  TensorSettings settings = withRadius(0.9, "sph-4");
  settings.normalization = Normalization::Count;
  for (const bool nearest : {false, true}) {
    SCOPED_TRACE(nearest ? "k nearest" : "radius");
    if (nearest) {
      settings.radius = 0;
      settings.k = 20;
    }
    const auto records = engine->estimate(points, points, settings);
    const auto expected = reference(points, points, settings, {});
    for (std::size_t i = 0; i < points.size(); ++i) {
      ASSERT_EQ(std::isnan(records[i].xx), std::isnan(expected[i].xx)) << i;
      if (!std::isnan(expected[i].xx)) {
        ASSERT_NEAR(records[i].yz, expected[i].yz, 1e-5 * expected[i].lambda3) << i;
        ASSERT_NEAR(records[i].lambda3, expected[i].lambda3, 1e-5 * expected[i].lambda3)
            << i;
      }
    }
  }
}

TEST_F(OpenCL, AdversarialCloudsGiveWhatTheReferenceGives)
{
  {
    SCOPED_TRACE("a lattice whose points lie exactly at the radius of each other");
    Points lattice;
    for (int x = 0; x < 12; ++x)
      for (int y = 0; y < 12; ++y)
        for (int z = 0; z < 12; ++z)
          lattice.emplace_back(0.1 * x, 0.1 * y, 0.1 * z);
    check(lattice, lattice, withRadius(0.3));
  }
  {
    SCOPED_TRACE("all points in one cell");
    check(box(500, Point(0.1, 0.1, 0.1), 5),
          box(50, Point(0.1, 0.1, 0.1), 6),
          withRadius(10));
  }
  {
    SCOPED_TRACE("one point per cell, and a far outlier");
    Points points = box(300, Point(1000, 1000, 1000), 7);
    points.emplace_back(5e8, -5e8, 5e8);
    check(points, points, withRadius(40));
  }
  {
    SCOPED_TRACE("a line, far from the origin, much longer than the radius");
    Points line;
    for (int i = 0; i < 3000; ++i)
      line.emplace_back(5e5 + i, 5e6 + 0.01 * (i % 7), 100 + 0.01 * (i % 3));
    check(line, line, withRadius(5));
  }
  {
    SCOPED_TRACE("duplicates, non-finite points, queries outside");
    Points points = box(200, Point(1, 1, 1), 8);
    points.insert(points.end(), 30, Point(5, 5, 5));
    points.emplace_back(not_known, 0, 0);
    Points queries = points;
    queries.emplace_back(-50, 0.5, 0.5);
    queries.emplace_back(1e9, 0.5, 0.5);
    queries.emplace_back(1.2, 0.5, 0.5);
    check(points, queries, withRadius(0.4));
  }
}

TEST_F(OpenCL, SmallestClouds)
{
  EXPECT_TRUE(engine->estimate({}, {}, withRadius(1)).empty());
  check({Point(1, 2, 3)}, {Point(1, 2, 3)}, withRadius(1));
  check({}, {Point(1, 2, 3)}, withRadius(1));
  check({Point(not_known, 0, 0)},
        {Point(not_known, 0, 0), Point(0, 0, 0)},
        withRadius(1));
}

// As on a device without double precision.
TEST_F(OpenCL, WithoutDoubleTheHostDecidesAtTheRadius)
{
  opencl::Context context("", 0, false);
  Points lattice;
  for (int i = 0; i < 1728; ++i)
    lattice.emplace_back(0.1 * (i % 12), 0.1 * (i / 12 % 12), 0.1 * (i / 144));
  const Points random = box(4000, Point(10, 10, 3), 20);
  for (const Points& points : {lattice, random}) {
    const TensorSettings settings = withRadius(points == lattice ? 0.3 : 1, "sph-3");
    const opencl::Outcome outcome = opencl::estimateOn(
        context, std::size_t{1} << 30, points, points, settings, {}, nullptr);
    expectEqual(outcome.records, reference(points, points, settings, {}));
    if (points == random) {
      EXPECT_LT(outcome.on_host, points.size() / 50);
    }
    else {
      EXPECT_GT(outcome.on_host, points.size() / 2);
    }
  }
}

TEST_F(OpenCL, CoincidentPointsHaveNoShapeInAnyCell)
{
  Points points = box(2000, Point(4000, 40, 40), 16);
  const Points once = points;
  points.insert(points.end(), once.begin(), once.end());
  check(points, points, withRadius(0.7));
}

TEST_F(OpenCL, RunningTwiceGivesTheSameBits)
{
  const Points points = box(3000, Point(8, 6, 2), 14);
  const TensorSettings settings = withRadius(0.9, "fermi-dirac-1");
  const auto once = engine->estimate(points, points, settings);
  const auto again = engine->estimate(points, points, settings);
  for (std::size_t i = 0; i < points.size(); ++i)
    ASSERT_EQ(std::memcmp(&once[i], &again[i], sizeof once[i]), 0) << "point " << i;
}

TEST_F(OpenCL, EveryStageIsTimed)
{
  const Points points = box(3000, Point(8, 6, 2), 15);
  engine->estimate(points, points, withRadius(0.9));
  const opencl::StageTimes& times = engine->stageTimes();
  for (const double seconds :
       {times.upload, times.grid, times.tensor, times.analysis, times.download})
    EXPECT_GT(seconds, 0);
}

TEST_F(OpenCL, ReportsUnsupportedRequests)
{
  TensorSettings settings = withRadius(1);
  settings.centroid = Centroid::WeightedMedian;
  EXPECT_THROW(engine->estimate({Point::Zero()}, {Point::Zero()}, settings),
               std::invalid_argument);
  settings = withRadius(1, Kernel::InverseSquaredDistance);
  EXPECT_THROW(engine->estimate({Point::Zero()}, {Point::Zero()}, settings),
               std::invalid_argument);
  // Not used around the query itself.
  settings = withRadius(1);
  settings.centroid_weighting = Kernel::InverseDistance;
  EXPECT_NO_THROW(engine->estimate({Point::Zero()}, {Point::Zero()}, settings));
  try {
    opencl::TensorEngine("no such device");
    FAIL() << "a device that does not exist was opened";
  }
  catch (const opencl::Error& error) {
    EXPECT_NE(std::string(error.what()).find("no such device"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find(engine->device().name), std::string::npos);
  }
}

TEST_F(OpenCL, FeatureFollowsTheRulesOfPcl)
{
  const float not_a_number = std::numeric_limits<float>::quiet_NaN();
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>);
  for (const Point& p : box(300, Point(3, 3, 1), 11))
    cloud->push_back(pcl::PointXYZ(static_cast<float>(p.x()),
                                   static_cast<float>(p.y()),
                                   static_cast<float>(p.z())));
  cloud->push_back(pcl::PointXYZ(not_a_number, 0, 0));
  cloud->is_dense = false;
  cloud->header.frame_id = "frame";
  const pcl::IndicesPtr indices(new pcl::Indices{300, 5, 5, 17});

  PointDistributionTensorEstimation<pcl::PointXYZ> cpu;
  PointDistributionTensorEstimationOCL<pcl::PointXYZ> ocl;
  pcl::PointCloud<PointDistributionTensor> expected, computed;
  for (auto* feature : {&cpu, static_cast<decltype(&cpu)>(&ocl)}) {
    feature->setInputCloud(cloud);
    feature->setIndices(indices);
    feature->setRadiusSearch(0.7);
    feature->setCentroid(Centroid::Mean);
    feature->compute(feature == &cpu ? expected : computed);
  }
  ASSERT_EQ(computed.size(), 4u);
  EXPECT_FALSE(computed.is_dense);
  EXPECT_EQ(computed.header.frame_id, "frame");
  expectEqual({expected.begin(), expected.end()}, {computed.begin(), computed.end()});

  ocl.setRadiusSearch(0); // no size of neighborhood given
  ocl.compute(computed);
  EXPECT_TRUE(computed.empty());
}
