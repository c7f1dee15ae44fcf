// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// Clusters compared with pcl::VoxelGrid, pcl::ApproximateVoxelGrid and the centroids of
// PCL's octree.
//   benchmark_clusters quality FILE LEAF...     equal numbers of representatives
//   benchmark_clusters speed FILE POINTS...     copies of a tile side by side
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <functional>
#include <string>
#include <vector>

#include <pcl/filters/approximate_voxel_grid.h>
#include <pcl/filters/voxel_grid.h>
#include <pcl/octree/octree_pointcloud_voxelcentroid.h>

#include <linelet/clustering/cluster_points.h>
#include <linelet/io/point_file.h>
#include <linelet/search/kd_tree.h>
#include <linelet/tensor/eigen_analysis.h>

#include "best_time.h"

using namespace linelet;

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

Cloud::Ptr
cloudOf(const Points& points)
{
  auto cloud = pcl::make_shared<Cloud>();
  cloud->reserve(points.size());
  for (const Point& p : points)
    cloud->emplace_back(static_cast<float>(p.x()),
                        static_cast<float>(p.y()),
                        static_cast<float>(p.z()));
  return cloud;
}

/** \brief Roof edges: points of a surface within a meter of a drop of at least two
 * meters. */
std::vector<bool>
edges(const Points& points)
{
  Points flat = points;
  for (Point& p : flat)
    p.z() = 0;
  constexpr double reach = 1, fall = 2, roof = 0.3;
  const KdTree tree(flat);
  std::vector<bool> edge(points.size());
  Indices found;
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::size_t level = 0, lower = 0, between = 0;
    tree.within(flat[i], reach, found);
    for (const Index k : found) {
      const double drop = points[i].z() - points[k].z();
      level += std::abs(drop) < roof ? 1 : 0;
      lower += drop > fall ? 1 : 0;
      between += drop >= roof && drop <= fall ? 1 : 0;
    }
    edge[i] = level >= 3 && lower >= 2 && between == 0;
  }
  return edge;
}

struct Score {
  double mean = 0, edge_mean = 0, edge_kept = 0;
};

/** \brief Distances of the points to the planes of their clusters: mean and smallest
 * eigenvector of the members. */
Score
score(const Points& points,
      const std::vector<bool>& edge,
      const Indices& cluster_of,
      std::size_t clusters,
      double leaf)
{
  Points mean(clusters, Point::Zero()), normal(clusters, Point::Zero());
  std::vector<double> count(clusters);
  for (std::size_t i = 0; i < points.size(); ++i) {
    mean[cluster_of[i]] += points[i];
    ++count[cluster_of[i]];
  }
  std::vector<SymmetricTensor> tensor(clusters);
  for (std::size_t k = 0; k < clusters; ++k)
    mean[k] /= std::max(count[k], 1.0);
  for (std::size_t i = 0; i < points.size(); ++i)
    tensor[cluster_of[i]].add(1, points[i] - mean[cluster_of[i]]);
  for (std::size_t k = 0; k < clusters; ++k)
    normal[k] = eigenAnalysis(tensor[k]).normal();
  Score score;
  std::size_t edges = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double distance =
        std::abs(normal[cluster_of[i]].dot(points[i] - mean[cluster_of[i]]));
    score.mean += distance;
    if (!edge[i])
      continue;
    ++edges;
    score.edge_mean += distance;
    score.edge_kept += distance < 0.05 * leaf ? 1 : 0;
  }
  score.mean /= static_cast<double>(points.size());
  score.edge_mean /= static_cast<double>(edges);
  score.edge_kept /= static_cast<double>(edges);
  return score;
}

/** \brief Members of the centers given by a filter, which has no others: the nearest
 * points. */
Indices
nearest(const Points& points, const Points& centers)
{
  const KdTree tree(centers);
  Indices result;
  Indices found;
  for (const Point& point : points) {
    tree.nearest(point, 1, found);
    result.push_back(found.front());
  }
  return result;
}

Points
pointsOf(const Cloud& cloud)
{
  Points points;
  for (const auto& p : cloud)
    points.emplace_back(p.x, p.y, p.z);
  return points;
}

void
report(const char* name, std::size_t clusters, const Score& score)
{
  std::printf("| %-28s | %7zu | %.4f | %.4f | %.3f |\n",
              name,
              clusters,
              score.mean,
              score.edge_mean,
              score.edge_kept);
  std::fflush(stdout);
}

void
compareQuality(const std::string& file, float leaf)
{
  io::Cloud input = io::readCloud(file);
  const Points& points = input.points;
  const std::vector<bool> edge = edges(points);
  const Cloud::Ptr cloud = cloudOf(points);
  std::printf("%s, leaf %g, %zu edge points\n"
              "| method | representatives | mean distance to the plane | at edges | "
              "edges kept |\n|---|---|---|---|---|\n",
              file.c_str(),
              static_cast<double>(leaf),
              static_cast<std::size_t>(std::count(edge.begin(), edge.end(), true)));
  Cloud out;
  pcl::VoxelGrid<pcl::PointXYZ> voxels;
  voxels.setInputCloud(cloud);
  voxels.setLeafSize(leaf, leaf, leaf);
  voxels.setSaveLeafLayout(true);
  voxels.filter(out);
  const std::size_t count = out.size();
  Indices members;
  for (const auto& p : *cloud)
    members.push_back(static_cast<Index>(voxels.getCentroidIndex(p)));
  report("VoxelGrid, its voxels", count, score(points, edge, members, count, leaf));
  report("VoxelGrid, nearest",
         count,
         score(points, edge, nearest(points, pointsOf(out)), count, leaf));
  // The leaf for which the approximate filter gives as many.
  float low = leaf / 4, high = leaf * 8;
  Cloud other;
  for (int k = 0; k < 18; ++k) {
    const float middle = std::sqrt(low * high);
    pcl::ApproximateVoxelGrid<pcl::PointXYZ> filter;
    filter.setInputCloud(cloud);
    filter.setLeafSize(middle, middle, middle);
    filter.filter(other);
    (other.size() > count ? low : high) = middle;
  }
  report("ApproximateVoxelGrid, nearest",
         other.size(),
         score(points, edge, nearest(points, pointsOf(other)), other.size(), leaf));
  for (const MoveRule rule : {MoveRule::Plane, MoveRule::Population})
    for (const double border : {0.25, 0.5})
      for (const unsigned moves : {0U, 1U, 2U, 4U, 8U}) {
        ClusterSettings settings;
        settings.count = count;
        settings.moves = moves;
        settings.move_by = rule;
        settings.border = border;
        const Clusters clusters = clusterPoints(points, settings);
        const std::size_t number = clusters.representatives.size();
        const std::string name = "linelet " + std::string(nameOf(rule)) + " border " +
                                 std::to_string(border).substr(0, 4) + " moves " +
                                 std::to_string(moves);
        report(name.c_str(),
               number,
               score(points, edge, clusters.cluster_of, number, leaf));
      }
}

/** \brief A method to time; it returns the number of cells. */
struct Candidate {
  std::string name;
  std::function<std::size_t()> work;
  bench::BestTime best;
  std::size_t cells = 0;
};

/** \brief Times all of them in turn, so that other work on the machine affects all
 * alike; the fastest round counts. */
void
race(std::vector<Candidate>& candidates)
{
  constexpr int rounds = 7;
  for (int round = 0; round < rounds; ++round)
    for (Candidate& candidate : candidates)
      candidate.best.run([&] { candidate.cells = candidate.work(); });
}

/** \brief Copies of a tile in rows, with that many points in total. */
Points
copies(const Points& tile, std::size_t count)
{
  Point low = tile.front(), high = low;
  for (const Point& p : tile) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const Point size = high - low;
  const auto side = static_cast<std::size_t>(std::ceil(
      std::sqrt(static_cast<double>(count) / static_cast<double>(tile.size()))));
  Points points;
  points.reserve(count);
  for (std::size_t copy = 0; points.size() < count; ++copy) {
    const Point place(size.x() * static_cast<double>(copy % side),
                      size.y() * static_cast<double>(copy / side),
                      0);
    for (std::size_t i = 0; i < tile.size() && points.size() < count; ++i)
      points.push_back(tile[i] + place);
  }
  return points;
}

void
compareSpeed(const std::string& file, std::size_t count)
{
  const Points points = copies(io::readCloud(file).points, count);
  std::vector<Candidate> candidates;
  const auto add = [&](const std::vector<double>& grid,
                       const char* what,
                       unsigned moves,
                       MoveRule rule) {
    ClusterSettings settings;
    settings.cells = grid;
    settings.moves = moves;
    settings.move_by = rule;
    char name[64];
    std::snprintf(
        name, sizeof(name), "%g x %g x %g, %s", grid[0], grid[1], grid[2], what);
    candidates.push_back(
        {name,
         [&points, settings] {
           return clusterPoints(points, settings).representatives.size();
         },
         {}});
  };
  add({75, 75, 15}, "no moves", 0, MoveRule::Plane);
  add({75, 75, 15}, "planes", 1, MoveRule::Plane);
  add({75, 75, 15}, "planes twice", 2, MoveRule::Plane);
  add({75, 75, 15}, "population", 1, MoveRule::Population);
  add({150, 150, 25}, "no moves", 0, MoveRule::Plane);
  add({200, 200, 100}, "no moves", 0, MoveRule::Plane);
  add({300, 300, 100}, "no moves", 0, MoveRule::Plane);
  add({300, 300, 100}, "planes twice", 2, MoveRule::Plane);
  Point low = points.front(), high = low;
  for (const Point& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const Eigen::Vector3f leaf =
      (high - low).cwiseQuotient(Point(75, 75, 15)).cast<float>();
  const Cloud::Ptr cloud = cloudOf(points);
  const auto filtered = [&](auto filter) {
    Cloud out;
    filter.setInputCloud(cloud);
    filter.setLeafSize(leaf.x(), leaf.y(), leaf.z());
    filter.filter(out);
    return out.size();
  };
  candidates.push_back({"pcl::VoxelGrid, leaf as 75 x 75 x 15",
                        [&] { return filtered(pcl::VoxelGrid<pcl::PointXYZ>()); },
                        {}});
  candidates.push_back(
      {"pcl::ApproximateVoxelGrid, the same",
       [&] { return filtered(pcl::ApproximateVoxelGrid<pcl::PointXYZ>()); },
       {}});
  candidates.push_back(
      {"pcl::octree, voxel centroids, cubes as wide",
       [&] {
         pcl::octree::OctreePointCloudVoxelCentroid<pcl::PointXYZ> tree(leaf.x());
         tree.setInputCloud(cloud);
         tree.defineBoundingBox();
         tree.addPointsFromInputCloud();
         pcl::octree::OctreePointCloudVoxelCentroid<pcl::PointXYZ>::AlignedPointTVector
             centroids;
         return static_cast<std::size_t>(tree.getVoxelCentroids(centroids));
       },
       {}});
  race(candidates);
  for (const Candidate& candidate : candidates)
    std::printf("| %9zu | %-36s | %8zu | %7.3f | %7.3f |\n",
                points.size(),
                candidate.name.c_str(),
                candidate.cells,
                candidate.best.wall,
                candidate.best.cpu);
  std::fflush(stdout);
}

} // namespace

int
main(int argc, char** argv)
{
  try {
    if (argc > 3 && std::strcmp(argv[1], "quality") == 0) {
      for (int k = 3; k < argc; ++k)
        compareQuality(argv[2], static_cast<float>(std::atof(argv[k])));
      return 0;
    }
    if (argc > 3 && std::strcmp(argv[1], "speed") == 0) {
      std::printf(
          "| points | method | cells | wall s | CPU s |\n|---|---|---|---|---|\n");
      for (int k = 3; k < argc; ++k)
        compareSpeed(argv[2], static_cast<std::size_t>(std::atof(argv[k])));
      return 0;
    }
    std::fprintf(stderr,
                 "benchmark_clusters quality FILE LEAF... | speed FILE POINTS...\n");
    return 2;
  }
  catch (const std::exception& error) {
    std::fprintf(stderr, "benchmark_clusters: %s\n", error.what());
    return 1;
  }
}
