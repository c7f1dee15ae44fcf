// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <linelet/features/point_distribution_tensor.h>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <gtest/gtest.h>

#include <pcl/console/print.h>
#include <pcl/conversions.h>
#include <pcl/PCLPointCloud2.h>
#include <pcl/search/brute_force.h>
#include <pcl/search/kdtree.h>
#include <pcl/search/octree.h>
#include <pcl/search/organized.h>

#include <linelet/search/pcl_search.h>

namespace linelet::test {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Estimation = PointDistributionTensorEstimation<pcl::PointXYZ>;
using RecordCloud = pcl::PointCloud<PointDistributionTensor>;
using SearchPtr = pcl::search::Search<pcl::PointXYZ>::Ptr;

inline constexpr float not_known = std::numeric_limits<float>::quiet_NaN();

/** \brief A curved surface and a wire as a depth camera sees them, with holes. */
inline Cloud::Ptr
depthImage()
{
  boost::random::mt19937 random(4);
  boost::random::normal_distribution<float> normal;
  auto cloud = pcl::make_shared<Cloud>(56, 42);
  for (unsigned row = 0; row < 42; ++row) {
    for (unsigned column = 0; column < 56; ++column) {
      const float x = (static_cast<float>(column) - 27.5f) / 50;
      const float y = (static_cast<float>(row) - 20.5f) / 50;
      const float depth =
          (row == 15 ? 1.5f : 2 + x * x + 0.3f * y) + 0.002f * normal(random);
      auto& point = cloud->at(column, row);
      point.x = x * depth;
      point.y = y * depth;
      point.z = depth;
      if ((column * 7 + row * 13) % 31 == 0)
        point.x = point.y = point.z = not_known;
    }
  }
  cloud->is_dense = false;
  return cloud;
}

/** \brief Multiples of 1/32, which float still represents at 5e5. */
inline Cloud::Ptr
scattered(std::size_t count, unsigned seed, float offset = 0)
{
  boost::random::mt19937 random(seed);
  boost::random::normal_distribution<double> normal;
  auto cloud = pcl::make_shared<Cloud>();
  const auto step = [&](double size) {
    return offset + static_cast<float>(std::round(32 * size * normal(random)) / 32);
  };
  for (std::size_t i = 0; i < count; ++i) {
    const float x = step(2), y = step(i % 2 == 0 ? 0.1 : 1);
    cloud->emplace_back(x, y, step(0.5));
  }
  return cloud;
}

inline std::vector<std::pair<std::string, SearchPtr>>
searches(bool organized)
{
  using Point = pcl::PointXYZ;
  std::vector<std::pair<std::string, SearchPtr>> all = {
      {"built in", nullptr},
      {"kd-tree", pcl::make_shared<pcl::search::KdTree<Point>>()},
      {"kd-tree, unsorted", pcl::make_shared<pcl::search::KdTree<Point>>(false)},
      {"octree", pcl::make_shared<pcl::search::Octree<Point>>(0.25)},
      {"brute force", pcl::make_shared<pcl::search::BruteForce<Point>>()},
  };
  if (organized)
    all.emplace_back("organized",
                     pcl::make_shared<pcl::search::OrganizedNeighbor<Point>>());
  return all;
}

inline RecordCloud
compute(Estimation& estimation)
{
  RecordCloud records;
  estimation.compute(records);
  return records;
}

inline void
expectSame(const RecordCloud& a, const RecordCloud& b, float tolerance = 0)
{
  ASSERT_EQ(a.size(), b.size());
  EXPECT_EQ(a.is_dense, b.is_dense);
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_EQ(a[i].neighbors, b[i].neighbors) << "query " << i;
    ASSERT_EQ(std::isnan(a[i].linearity), std::isnan(b[i].linearity)) << "query " << i;
    if (std::isnan(a[i].linearity))
      continue;
    ASSERT_NEAR(a[i].linearity, b[i].linearity, tolerance) << "query " << i;
    ASSERT_NEAR(a[i].planarity, b[i].planarity, tolerance) << "query " << i;
    ASSERT_NEAR(a[i].sphericity, b[i].sphericity, tolerance) << "query " << i;
  }
}

/** \brief The result of the core for the points of a cloud. */
inline RecordCloud
reference(const Cloud& surface, const Cloud& queries, const TensorSettings& settings)
{
  RecordCloud records;
  records.is_dense = true;
  for (const PointDistributionTensor& record :
       estimateTensors(pointsOf(surface), pointsOf(queries), settings)) {
    records.push_back(record);
    records.is_dense = records.is_dense && !std::isnan(record.linearity);
  }
  return records;
}

class PdtEstimation : public testing::Test {
protected:
  void
  SetUp() override
  {
    pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS); // errors are provoked
  }
};

} // namespace linelet::test
