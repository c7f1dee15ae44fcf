// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/pieces/candidates.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <numeric>

#include <Eigen/Eigenvalues>

#include <linelet/support/threads.h>
#include <linelet/tensor/point_moments.h>
#include <linelet/tensor/shape_factors.h>

namespace linelet::powerline {

namespace {

struct Scale {
  double radius;
  double linearity;
  std::size_t least_points;
};

// Without the smallest scale, wires a meter apart merge; without the largest, sparse
// ones are lost.
constexpr std::array<Scale, 4> scales = {
    {{1, 0.85, 5}, {2, 0.93, 5}, {4, 0.975, 5}, {8, 0.995, 6}}};
constexpr double voxel = 0.5; // one seed, or one point of the coarse cloud, each
constexpr double steepest_seed = 0.7;    // of a wire's direction, as sine: 45 degrees
constexpr double round_enough = 0.3;     // sphericity that ends the search for a line
constexpr std::size_t enough_points = 8; // points that make it credible
constexpr double among_radius = 4; // meters, of the search for a wire among others
constexpr double bundle_linearity = 0.5;
constexpr std::size_t crowded_ball = 400; // neighbors, too many for wires alone
constexpr double bundle_tube = 0.12;      // meters

struct VoxelRun {
  Indices order;                   // candidates, voxel by voxel
  std::vector<std::size_t> begins; // one entry more than voxels
};

VoxelRun
sortIntoVoxels(const Points& points)
{
  Point low = Point::Constant(std::numeric_limits<double>::infinity());
  for (const Point& p : points)
    low = low.cwiseMin(p);
  low = voxel * (low / voxel).array().floor(); // the same in every part of a cloud
  std::vector<std::pair<std::uint64_t, Index>> keys(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point cell = ((points[i] - low) / voxel).array().floor();
    std::uint64_t key = 0;
    for (int axis = 0; axis < 3; ++axis)
      key = key << 21 | (static_cast<std::uint64_t>(cell[axis]) & 0x1FFFFF);
    keys[i] = {key, static_cast<Index>(i)};
  }
  std::sort(keys.begin(), keys.end());
  VoxelRun run;
  run.order.reserve(keys.size());
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (i == 0 || keys[i].first != keys[i - 1].first)
      run.begins.push_back(i);
    run.order.push_back(keys[i].second);
  }
  run.begins.push_back(keys.size());
  return run;
}

struct Shape {
  std::size_t count = 0;
  double linearity = 0, sphericity = 0;
  Point direction = Point::UnitX();
};

Shape
shapeAround(const UniformGrid& grid, const Point& center, double radius)
{
  Shape shape;
  PointMoments moments;
  grid.forEachOffsetWithin(
      center, radius, [&](const Point& v, double) { moments.add(v); });
  shape.count = moments.count;
  if (shape.count < 3)
    return shape;
  // The closed form: eigenAnalysis takes three times as long for digits that no
  // threshold here needs.
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(moments.covariance().matrix());
  const Point values = solver.eigenvalues().cwiseMax(0);
  if (!(values.sum() > 0))
    return shape;
  const ShapeFactors factors = shapeFactors(values);
  shape.linearity = factors.linearity;
  shape.sphericity = factors.sphericity;
  shape.direction = solver.eigenvectors().col(2);
  return shape;
}

// Among close wires, the neighborhood is not a line, but there is one through the point
// itself, in about the common direction, with an empty guard ring around it.
Seed
seedAmongOthers(const Candidates& candidates, Index c)
{
  const Seed none = {c, 0, 0, Point::Zero()};
  const Point& center = candidates.points[c];
  std::vector<Point> around;
  candidates.grid.forEachOffsetWithin(
      center, among_radius, [&](const Point& v, double) { around.push_back(v); });
  if (around.size() < 12 || around.size() > crowded_ball)
    return none;
  Point direction;
  for (const double cut : {1e3, 0.6, 0.4, 0.25}) {
    // Tukey's weights around the line, and moments about the point, not the mean.
    Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
    for (const Point& v : around) {
      const double off = cut < 1e3 ? v.cross(direction).squaredNorm() / (cut * cut) : 0;
      if (off < 1)
        squares += (1 - off) * (1 - off) * v * v.transpose();
    }
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
    solver.computeDirect(squares);
    direction = solver.eigenvectors().col(2);
    if (!(shapeFactors(solver.eigenvalues()).linearity >= bundle_linearity) ||
        std::abs(direction.z()) > steepest_seed)
      return none;
  }
  std::size_t tube = 0, guard_ring = 0;
  std::array<bool, 8> filled = {};
  for (const Point& v : around) {
    const double off = v.cross(direction).norm();
    tube += off <= bundle_tube;
    guard_ring += off > bundle_tube && off <= 2 * bundle_tube;
    if (off <= bundle_tube) {
      const double place = (direction.dot(v) / among_radius + 1) / 2;
      filled[static_cast<std::size_t>(std::clamp(place * 8, 0.0, 7.0))] = true;
    }
  }
  if (tube < 5 || guard_ring * 3 > tube ||
      std::count(filled.begin(), filled.end(), true) < 5)
    return none;
  return {c, 0.5F, static_cast<float>(among_radius), direction};
}

} // namespace

Candidates
findCandidates(const Points& points,
               const Ground& ground,
               double min_height,
               unsigned threads)
{
  // Block by block: how many there are, then where they go.
  constexpr std::size_t block = 1 << 16;
  const std::size_t blocks = (points.size() + block - 1) / block;
  std::vector<float> above(points.size()); // NaN: no candidate
  std::vector<std::size_t> begins(blocks + 1, 0);
#pragma omp parallel for schedule(dynamic) num_threads(threadCount(threads))
  for (std::size_t b = 0; b < blocks; ++b)
    for (std::size_t i = b * block; i < std::min(points.size(), (b + 1) * block); ++i) {
      const double h = points[i].z() - ground.heightAt(points[i].x(), points[i].y());
      const bool higher = h > min_height && points[i].allFinite();
      above[i] =
          higher ? static_cast<float>(h) : std::numeric_limits<float>::quiet_NaN();
      begins[b + 1] += higher ? 1 : 0;
    }
  std::partial_sum(begins.begin(), begins.end(), begins.begin());
  Points found(begins.back());
  Indices input(begins.back());
  std::vector<float> height(begins.back());
#pragma omp parallel for schedule(dynamic) num_threads(threadCount(threads))
  for (std::size_t b = 0; b < blocks; ++b) {
    std::size_t next = begins[b];
    for (std::size_t i = b * block; i < std::min(points.size(), (b + 1) * block); ++i) {
      if (std::isnan(above[i]))
        continue;
      found[next] = points[i];
      input[next] = static_cast<Index>(i);
      height[next++] = above[i];
    }
  }
  above = {};
  UniformGrid grid(found, 1);
  return {std::move(found),
          std::move(input),
          std::move(height),
          std::move(grid),
          min_height};
}

std::vector<Seed>
findSeeds(const Candidates& candidates, unsigned threads, ProgressMonitor* monitor)
{
  const VoxelRun voxels = sortIntoVoxels(candidates.points);
  const std::size_t count = voxels.begins.size() - 1;
  Points coarse(count);
  for (std::size_t v = 0; v < count; ++v) {
    Point sum = Point::Zero();
    for (std::size_t i = voxels.begins[v]; i < voxels.begins[v + 1]; ++i)
      sum += candidates.points[voxels.order[i]];
    coarse[v] = sum / static_cast<double>(voxels.begins[v + 1] - voxels.begins[v]);
  }
  const UniformGrid coarse_grid(coarse, 2);
  if (monitor != nullptr)
    monitor->begin("seeds", count);

  std::vector<Seed> best(count);
  std::atomic<bool> stop{false};
  const auto blocks = static_cast<std::ptrdiff_t>((count + 4095) / 4096);
#pragma omp parallel for schedule(dynamic) num_threads(threadCount(threads))
  for (std::ptrdiff_t block = 0; block < blocks; ++block) {
    if (stop || (monitor != nullptr && monitor->canceled())) {
      stop = true;
      continue;
    }
    const std::size_t first = static_cast<std::size_t>(block) * 4096;
    const std::size_t last = std::min(count, first + 4096);
    for (std::size_t v = first; v < last; ++v) {
      const Index c = voxels.order[voxels.begins[v]];
      best[v] = {c, 0, 0, Point::Zero()};
      bool round = false;
      for (const Scale& scale : scales) {
        const bool fine = scale.radius <= 2;
        const Shape shape = shapeAround(
            fine ? candidates.grid : coarse_grid, candidates.points[c], scale.radius);
        if (shape.count >= enough_points && shape.sphericity > round_enough) {
          round = true;
          break;
        }
        if (shape.count < scale.least_points || shape.linearity < scale.linearity ||
            std::abs(shape.direction.z()) > steepest_seed ||
            shape.linearity <= best[v].linearity)
          continue;
        best[v] = {c,
                   static_cast<float>(shape.linearity),
                   static_cast<float>(scale.radius),
                   shape.direction};
      }
      if (!round && best[v].linearity <= 0)
        best[v] = seedAmongOthers(candidates, c);
    }
    if (monitor != nullptr)
      monitor->advance(last - first);
  }
  if (stop)
    throw Canceled();
  best.erase(std::remove_if(best.begin(),
                            best.end(),
                            [](const Seed& seed) { return seed.linearity <= 0; }),
             best.end());
  std::sort(best.begin(), best.end(), [](const Seed& a, const Seed& b) {
    return a.linearity != b.linearity ? a.linearity > b.linearity
                                      : a.candidate < b.candidate;
  });
  return best;
}

} // namespace linelet::powerline
