// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// A point type that is not prebuilt: PCL's own templates (the kd-tree of every
// pcl::Feature) have to be instantiated for it as well.
#define PCL_NO_PRECOMPILE
#include <linelet/features/point_distribution_tensor.h>

#include <gtest/gtest.h>
#include <pcl/search/kdtree.h>

struct EchoPoint {
  PCL_ADD_POINT4D
  float echo_width;
  PCL_MAKE_ALIGNED_OPERATOR_NEW
} EIGEN_ALIGN16;

POINT_CLOUD_REGISTER_POINT_STRUCT(
    EchoPoint, (float, x, x)(float, y, y)(float, z, z)(float, echo_width, echo_width))

TEST(PdtEstimation, WorksForATypeOfOnesOwn)
{
  auto cloud = pcl::make_shared<pcl::PointCloud<EchoPoint>>();
  for (int i = 0; i < 50; ++i) {
    EchoPoint point;
    point.x = static_cast<float>(i);
    point.y = 2 * point.x;
    point.z = 0;
    cloud->push_back(point);
  }
  linelet::PointDistributionTensorEstimation<EchoPoint> estimation;
  estimation.setInputCloud(cloud);
  for (const bool own_search : {false, true}) {
    if (own_search)
      estimation.setSearchMethod(pcl::make_shared<pcl::search::KdTree<EchoPoint>>());
    estimation.setKSearch(5);
    pcl::PointCloud<linelet::PointDistributionTensor> records;
    estimation.compute(records);
    ASSERT_EQ(records.size(), 50u);
    EXPECT_EQ(records[20].neighbors, 5u);
    EXPECT_FLOAT_EQ(records[20].linearity, 1);
    EXPECT_NEAR(records[20].major_y, 2 / std::sqrt(5.0), 1e-6);
  }
}
