// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include <pcl/console/print.h>

#include <linelet/screen/screen_space_normal_estimation.h>

#include "screen/depth_camera.h"

using namespace linelet;
using namespace linelet::test;

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

Cloud::Ptr
tiltedPlane()
{
  const DepthPicture picture(40, 30, 1, [](const Point& ray) {
    return plane(ray, Point(0.4, -0.3, -0.85).normalized(), -5);
  });
  auto cloud = pcl::make_shared<Cloud>(40, 30);
  for (std::size_t k = 0; k < cloud->size(); ++k)
    (*cloud)[k] = {picture.samples.x[k], picture.samples.y[k], picture.samples.z[k]};
  return cloud;
}

TEST(ScreenSpaceNormalEstimation, GivesNormalsTowardTheSensor)
{
  const Cloud::Ptr cloud = tiltedPlane();
  ScreenSpaceNormalEstimation<pcl::PointXYZ> estimation;
  estimation.setInputCloud(cloud);
  pcl::PointCloud<pcl::Normal> normals;
  estimation.compute(normals);
  ASSERT_EQ(normals.width, 40u);
  ASSERT_EQ(normals.height, 30u);
  // All except the corners, which have diagonals on one side only.
  EXPECT_FALSE(normals.is_dense);
  const auto corner = [&](std::size_t k) {
    return (k % 40 == 0 || k % 40 == 39) && (k < 40 || k >= 29 * 40);
  };
  const Eigen::Vector3f truth = Eigen::Vector3f(0.4F, -0.3F, -0.85F).normalized();
  for (std::size_t k = 0; k < normals.size(); ++k) {
    if (corner(k)) {
      EXPECT_TRUE(std::isnan(normals[k].normal_x));
      continue;
    }
    EXPECT_GT(normals[k].getNormalVector3fMap().dot(truth), 0.9999F);
  }
  // Seen from behind, they face that way.
  cloud->sensor_origin_ = Eigen::Vector4f(0, 0, 100, 0);
  estimation.compute(normals);
  for (std::size_t k = 0; k < normals.size(); ++k)
    if (!corner(k)) {
      EXPECT_LT(normals[k].getNormalVector3fMap().dot(truth), -0.9999F);
    }
}

TEST(ScreenSpaceNormalEstimation, FollowsTheRulesOfFeatures)
{
  const Cloud::Ptr cloud = tiltedPlane();
  (*cloud)(10, 10).z = std::numeric_limits<float>::quiet_NaN();
  cloud->is_dense = false;
  ScreenSpaceNormalEstimation<pcl::PointXYZ> estimation;
  estimation.setInputCloud(cloud);
  pcl::PointCloud<pcl::Normal> all, some;
  estimation.compute(all);
  EXPECT_FALSE(all.is_dense);
  EXPECT_TRUE(std::isnan(all(10, 10).normal_x));
  EXPECT_FALSE(std::isnan(all(11, 10).normal_x));
  auto indices = pcl::make_shared<pcl::Indices>(pcl::Indices{3, 410, 700});
  estimation.setIndices(indices);
  estimation.compute(some);
  ASSERT_EQ(some.size(), 3u);
  EXPECT_EQ(some[0].normal_x, all[3].normal_x);
  EXPECT_TRUE(std::isnan(some[1].normal_x));
  EXPECT_EQ(some[2].normal_z, all[700].normal_z);
}

TEST(ScreenSpaceNormalEstimation, TakesItsSettingsAtOnce)
{
  ScreenSpaceNormalEstimation<pcl::PointXYZ> one_by_one, at_once;
  one_by_one.setMethod(ScreenNormalMethod::PlaneDiagonals);
  one_by_one.setPattern(25);
  one_by_one.setSmoothing(2);
  at_once.setSettings(one_by_one.getSettings());
  EXPECT_EQ(at_once.getPattern(), 25u);
  pcl::PointCloud<pcl::Normal> expected, normals;
  one_by_one.setInputCloud(tiltedPlane());
  one_by_one.compute(expected);
  at_once.setInputCloud(tiltedPlane());
  at_once.compute(normals);
  ASSERT_EQ(normals.size(), expected.size());
  EXPECT_EQ(normals(9, 9).normal_x, expected(9, 9).normal_x);
  EXPECT_EQ(normals(9, 9).normal_z, expected(9, 9).normal_z);
}

TEST(ScreenSpaceNormalEstimation, ReportsErrorsAndReturnsNothing)
{
  pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
  pcl::PointCloud<pcl::Normal> normals;
  ScreenSpaceNormalEstimation<pcl::PointXYZ> estimation;
  estimation.compute(normals);
  EXPECT_TRUE(normals.empty());
  const auto line = pcl::make_shared<Cloud>(50, 1);
  estimation.setInputCloud(line);
  estimation.compute(normals);
  EXPECT_TRUE(normals.empty());
  estimation.setInputCloud(tiltedPlane());
  estimation.setPattern(8);
  estimation.compute(normals);
  EXPECT_TRUE(normals.empty());
  estimation.setPattern(9);
  estimation.setIndices(pcl::make_shared<pcl::Indices>(1, 5000));
  estimation.compute(normals);
  EXPECT_TRUE(normals.empty());
  pcl::console::setVerbosityLevel(pcl::console::L_INFO);
}

} // namespace
