// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include <pcl/console/print.h>
#include <pcl/filters/voxel_grid.h>

#include <linelet/clustering/curvilinear_grid_clustering.h>

#include "clustering/cluster_fixture.h"

using namespace linelet;
using namespace linelet::test;

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZI>;

Cloud::Ptr
houseCloud()
{
  auto cloud = pcl::make_shared<Cloud>();
  // Both grids begin at the origin.
  cloud->push_back(pcl::PointXYZI(0, 0, -0.25F, 1));
  for (const Point& p : house(20000, 9))
    cloud->push_back({static_cast<float>(p.x()),
                      static_cast<float>(p.y()),
                      static_cast<float>(std::max(p.z(), -0.2)),
                      static_cast<float>(p.z() * 10)});
  cloud->header.frame_id = "house";
  return cloud;
}

TEST(CurvilinearGridClustering, WithoutMovesIsVoxelGrid)
{
  const Cloud::Ptr cloud = houseCloud();
  constexpr float leaf = 0.25F; // a power of two, so that both compute the same cells
  Cloud expected, result;
  pcl::VoxelGrid<pcl::PointXYZI> voxels;
  voxels.setInputCloud(cloud);
  voxels.setLeafSize(leaf, leaf, leaf);
  voxels.filter(expected);
  CurvilinearGridClustering<pcl::PointXYZI> clustering;
  clustering.setInputCloud(cloud);
  clustering.setLeafSize(leaf);
  clustering.setMoves(0);
  clustering.filter(result);
  ASSERT_EQ(result.size(), expected.size());
  EXPECT_EQ(result.header.frame_id, "house");
  EXPECT_TRUE(result.is_dense);
  const auto key = [&](const pcl::PointXYZI& p) {
    return std::array<int, 3>{static_cast<int>(std::floor(p.z / leaf)),
                              static_cast<int>(std::floor(p.y / leaf)),
                              static_cast<int>(std::floor(p.x / leaf))};
  };
  const auto before = [&](const auto& a, const auto& b) { return key(a) < key(b); };
  std::sort(result.begin(), result.end(), before);
  std::sort(expected.begin(), expected.end(), before);
  for (std::size_t i = 0; i < result.size(); ++i) {
    EXPECT_NEAR(result[i].x, expected[i].x, 1e-4);
    EXPECT_NEAR(result[i].y, expected[i].y, 1e-4);
    EXPECT_NEAR(result[i].z, expected[i].z, 1e-4);
    EXPECT_NEAR(result[i].intensity, expected[i].intensity, 1e-3);
  }
}

TEST(CurvilinearGridClustering, FollowsTheRulesOfFilters)
{
  const Cloud::Ptr cloud = houseCloud();
  (*cloud)[6].x = std::numeric_limits<float>::quiet_NaN();
  cloud->is_dense = false;
  CurvilinearGridClustering<pcl::PointXYZI> clustering(true);
  clustering.setInputCloud(cloud);
  clustering.setGrid(10, 6, 4);
  auto indices = pcl::make_shared<pcl::Indices>();
  for (int i = 0; i < 1000; i += 2)
    indices->push_back(i);
  clustering.setIndices(indices);
  Cloud result;
  clustering.filter(result);
  EXPECT_EQ(*clustering.getRemovedIndices(), pcl::Indices{6});
  const Clusters& clusters = clustering.getClusters();
  ASSERT_EQ(clusters.representatives.size(), result.size());
  std::size_t sum = 0;
  for (const Representative& r : clusters.representatives)
    sum += r.count;
  EXPECT_EQ(sum, indices->size() - 1);
  for (std::size_t i = 0; i < cloud->size(); ++i)
    EXPECT_EQ(clusters.cluster_of[i] != Clusters::none,
              i < 1000 && i % 2 == 0 && i != 6);

  // The output may be the input.
  Cloud same = *cloud;
  CurvilinearGridClustering<pcl::PointXYZI> in_place;
  in_place.setInputCloud(pcl::make_shared<Cloud>(same));
  in_place.setGrid(10, 6, 4);
  Cloud all;
  in_place.filter(all);
  const auto alias = pcl::make_shared<Cloud>(same);
  in_place.setInputCloud(alias);
  in_place.filter(*alias);
  EXPECT_EQ(alias->size(), all.size());
}

TEST(CurvilinearGridClustering, IsCanceledByItsMonitorAndWorksAgain)
{
  class Impatient : public ProgressMonitor {
  public:
    bool
    canceled() const override
    {
      return stop;
    }
    bool stop = true;
  } monitor;
  const Cloud::Ptr cloud = houseCloud();
  CurvilinearGridClustering<pcl::PointXYZI> clustering;
  clustering.setInputCloud(cloud);
  clustering.setLeafSize(0.5);
  clustering.setProgressMonitor(&monitor);
  Cloud result;
  EXPECT_THROW(clustering.filter(result), Canceled);
  monitor.stop = false;
  clustering.filter(result);
  clustering.setProgressMonitor(nullptr);
  Cloud unwatched;
  clustering.filter(unwatched);
  EXPECT_GT(result.size(), 0u);
  EXPECT_EQ(result.size(), unwatched.size());
}

TEST(CurvilinearGridClustering, ReportsErrorsAndReturnsNothing)
{
  pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
  const Cloud::Ptr cloud = houseCloud();
  Cloud result = *cloud;
  CurvilinearGridClustering<pcl::PointXYZI> clustering;
  clustering.setInputCloud(cloud);
  clustering.filter(result); // no grid
  EXPECT_TRUE(result.empty());
  clustering.setLeafSize(-1);
  result = *cloud;
  clustering.filter(result);
  EXPECT_TRUE(result.empty());
  clustering.setLeafSize(1);
  clustering.setIndices(pcl::make_shared<pcl::Indices>(1, 1000000));
  result = *cloud;
  clustering.filter(result);
  EXPECT_TRUE(result.empty());
  CurvilinearGridClustering<pcl::PointXYZI> empty;
  empty.setInputCloud(pcl::make_shared<Cloud>());
  empty.setLeafSize(1);
  empty.filter(result);
  EXPECT_TRUE(result.empty());
  pcl::console::setVerbosityLevel(pcl::console::L_INFO);
}

} // namespace
