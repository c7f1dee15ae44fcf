// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// The feature's templates are instantiated here: its library would bring VTK and MPI.
#define PCL_NO_PRECOMPILE
#include <pcl/features/impl/normal_3d.hpp>
#include <pcl/features/impl/normal_3d_omp.hpp>
#include <pcl/features/normal_3d_omp.h>
#include <pcl/kdtree/impl/kdtree_flann.hpp>
#include <pcl/search/impl/kdtree.hpp>

#include "rivals.h"
#include "scenes.h"

namespace linelet::benchmarking {

namespace {

pcl::PointCloud<pcl::PointXYZ>::Ptr
cloudOf(const Points& points)
{
  auto cloud = std::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  cloud->reserve(points.size());
  for (const Point& p : points)
    cloud->emplace_back(static_cast<float>(p.x()),
                        static_cast<float>(p.y()),
                        static_cast<float>(p.z()));
  return cloud;
}

} // namespace

RivalTime
pclNormals(const Points& points, double radius, unsigned threads, std::size_t sample)
{
  const auto cloud = cloudOf(points);
  auto tree = std::make_shared<pcl::search::KdTree<pcl::PointXYZ>>(false);
  RivalTime time{};
  double start = seconds(threads);
  tree->setInputCloud(cloud);
  time.build = seconds(threads) - start;
  pcl::NormalEstimationOMP<pcl::PointXYZ, pcl::Normal> normals(threads);
  normals.setInputCloud(cloud);
  normals.setSearchMethod(tree);
  normals.setRadiusSearch(radius);
  auto indices = std::make_shared<pcl::Indices>();
  // In consecutive runs, so that sorted input shows its merits.
  constexpr std::size_t run = 100;
  for (std::size_t i = 0; i < sample; ++i)
    indices->push_back(
        static_cast<int>((i / run) * run * (points.size() / sample) + i % run));
  normals.setIndices(indices);
  pcl::PointCloud<pcl::Normal> out;
  start = seconds(threads);
  normals.compute(out);
  time.query = (seconds(threads) - start) / static_cast<double>(sample);
  return time;
}

RivalTime
flannSearch(const Points& points, double radius, std::size_t sample)
{
  const auto cloud = cloudOf(points);
  pcl::KdTreeFLANN<pcl::PointXYZ> tree(false);
  RivalTime time{};
  double start = cpuSeconds();
  tree.setInputCloud(cloud);
  time.build = cpuSeconds() - start;
  pcl::Indices found;
  std::vector<float> squared;
  start = cpuSeconds();
  const std::size_t step = points.size() / sample;
  for (std::size_t i = 0; i < sample; ++i)
    tree.radiusSearch((*cloud)[i * step], radius, found, squared);
  time.query = (cpuSeconds() - start) / static_cast<double>(sample);
  return time;
}

} // namespace linelet::benchmarking
