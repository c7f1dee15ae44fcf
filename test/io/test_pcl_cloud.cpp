// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// Clouds in PCL's types and back.

#include <gtest/gtest.h>

#include <linelet/io/pcl_cloud.h>

using namespace linelet;
using namespace linelet::io;

TEST(PclCloud, TakesWhatBothHave)
{
  Cloud cloud;
  cloud.shift = {500000, 5000000, 0};
  cloud.points = {{1.25, 2, 3}, {4, 5, NAN}};
  cloud.set({"intensity", std::vector<std::uint16_t>{7, 65535}, {}});
  cloud.set({"red", std::vector<std::uint16_t>{0xFF00, 0x0100}, {}});
  cloud.set({"green", std::vector<std::uint16_t>{0, 0}, {}});
  cloud.set({"blue", std::vector<std::uint16_t>{0x8000, 0}, {}});

  const auto intensity = toPcl<pcl::PointXYZI>(cloud);
  ASSERT_EQ(intensity.size(), 2U);
  EXPECT_FALSE(intensity.is_dense);
  EXPECT_EQ(intensity[0].x, 1.25F);
  EXPECT_EQ(intensity[1].intensity, 65535.0F);
  const auto color = toPcl<pcl::PointXYZRGB>(cloud);
  EXPECT_EQ(color[0].r, 255);
  EXPECT_EQ(color[1].r, 1);
  EXPECT_EQ(color[0].b, 128);
  EXPECT_EQ(toPcl<pcl::PointXYZ>(cloud)[0].z, 3.0F);
}

TEST(PclCloud, GivesBackWhatTheTypeHolds)
{
  pcl::PointCloud<pcl::PointXYZRGBNormal> in;
  in.resize(1);
  in[0].x = 1;
  in[0].g = 200;
  in[0].normal_z = 1;
  in[0].curvature = 0.5F;
  const Cloud cloud = fromPcl(in, Point(10, 20, 30));
  EXPECT_EQ(cloud.shift, Point(10, 20, 30));
  EXPECT_EQ(cloud.points.at(0), Point(1, 0, 0));
  EXPECT_EQ(valueAt(*cloud.find("green"), 0), 200);
  EXPECT_EQ(valueAt(*cloud.find("normal_z"), 0), 1);
  EXPECT_EQ(valueAt(*cloud.find("curvature"), 0), 0.5);
  EXPECT_EQ(cloud.find("intensity"), nullptr);
}
