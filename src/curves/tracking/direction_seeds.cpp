// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "direction_seeds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>

#include <Eigen/Core>

#include "ball_points.h"
#include "curves/ridges/distinct_points.h"
#include "support/parallel_chunks.h"
#include "surface_scales.h"

namespace linelet {

namespace {

constexpr std::size_t neighbors = 6; // the nearest; one of them is the next of a curve
// D; where neighbors are nearer, a ball suffices.
constexpr double sparse = 1;
constexpr double growth = 1.4; // of the ball until it holds that many
// Of the cylinder, in distances to the neighbor: half its length, over which a curve is
// straight enough, and its radius.
constexpr double half_length = 3.5, radius = 0.1;
constexpr double least_members = 6;
constexpr std::size_t most_points = 64; // looked at around each, the nearest

/** \brief Places in \a scene of the points that lie on no surface. */
Indices
offSurfaces(const TrackedScene& scene)
{
  Indices result;
  for (std::size_t i = 0; i < scene.surface.size(); ++i)
    if (scene.surface[i] == 0)
      result.push_back(static_cast<Index>(i));
  return result;
}

/** \brief The points that lie on no surface, in a grid of their own. */
struct OpenPoints {
  explicit OpenPoints(const TrackedScene& scene)
      : unit(scene.unit),
        scene_indices(offSurfaces(scene)),
        grid(pointsAt(scene.points(), scene_indices), row_size * unit)
  {
    free.reserve(grid.size());
    for (const Index i : grid.inputIndices())
      free.push_back(scene.taken[scene_indices[i]] == 0);
  }

  static constexpr double row_size = 2.5; // D

  double unit; ///< D of the scene
  Indices scene_indices;
  UniformGrid grid;
  std::vector<char> free; ///< per sorted index, whether no curve explains it yet
};

using Neighbors = std::vector<UniformGrid::Neighbor>; // by their sorted indices

/** \brief What is found around a point, kept to reuse its memory. */
struct Around {
  Neighbors nearest;
  BallPoints in_ball;
};

/** \brief Finds the points around \a at. Those of other curves count, too, as what
 * these leave unexplained is judged against them. */
void
findPointsAround(const UniformGrid& grid,
                 const Point& at,
                 double reach,
                 BallPoints& found)
{
  found.count = 0;
  grid.forEachRun(at, reach, [&](std::size_t begin, std::size_t end) {
    appendPointsInBall(at, reach, grid.sortedPoints(), begin, end, found);
  });
}

/** \brief Whether more than \ref neighbors points lie within \a reach. */
bool
isCrowded(const UniformGrid& grid, const Point& at, double reach)
{
  std::size_t count = 0;
  grid.forEachRun(at, reach, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end && count <= neighbors; ++i)
      count += (grid.sortedPoints()[i] - at).squaredNorm() <= reach * reach;
  });
  return count > neighbors;
}

/** \brief Distance within which the nearest neighbors lie; 0 where they are no farther
 * than in most of the scene, or farther than a curve could be seen. */
double
reachOfNeighbors(const OpenPoints& open, const Point& at)
{
  double reach = sparse * open.unit;
  if (isCrowded(open.grid, at, reach))
    return 0;
  while (reach <= largest_radius * open.unit) {
    reach *= growth;
    if (isCrowded(open.grid, at, reach))
      return reach;
  }
  return 0;
}

/** \brief Offsets of points as columns, for loops over all of them at once. */
struct Offsets {
  using Column = std::array<float, most_points>;

  std::size_t count;
  Column x, y, z, squared;
  std::array<int, most_points> free; ///< 1: no curve explains it yet

  Offsets(const OpenPoints& open, const Point& at, const Neighbors& points)
      : count(points.size())
  {
    for (std::size_t k = 0; k < count; ++k) {
      const Index i = points[k].second;
      const Eigen::Vector3f v = (open.grid.sortedPoints()[i] - at).cast<float>();
      free[k] = open.free[i] ? 1 : 0;
      x[k] = v.x();
      y[k] = v.y();
      z[k] = v.z();
      squared[k] = v.squaredNorm();
    }
  }
};

/** \brief What lies in a cylinder about the origin. */
struct InCylinder {
  float in_ball = 0; ///< points in the ball around its middle that holds it
  float members = 0; ///< free points in the cylinder

  InCylinder(const Offsets& offsets,
             const Eigen::Vector3f& direction,
             float squared_half,
             float squared_radius)
      : count_(static_cast<Eigen::Index>(offsets.count))
  {
    int inside = 0, chosen = 0;
    for (std::size_t k = 0; k < offsets.count; ++k) {
      const float along = direction.x() * offsets.x[k] + direction.y() * offsets.y[k] +
                          direction.z() * offsets.z[k];
      off_[k] = offsets.squared[k] - along * along;
      // Without branches, so that compilers use vectors.
      const int near = static_cast<int>(offsets.squared[k] <= squared_half);
      const int within = static_cast<int>(off_[k] <= squared_radius);
      const int member = near & within & offsets.free[k];
      member_[k] = static_cast<float>(member);
      inside += near;
      chosen += member;
    }
    in_ball = static_cast<float>(inside);
    members = static_cast<float>(chosen);
  }

  /** \brief Sum of the squared distances of the members from the axis. */
  float
  squaresOff() const
  {
    using Map = Eigen::Map<const Eigen::ArrayXf>;
    return (Map(member_.data(), count_) * Map(off_.data(), count_)).sum();
  }

private:
  Eigen::Index count_;
  Offsets::Column off_, member_;
};

/** \brief Whether a cylinder through the middle of \a ball and one of its nearest
 * points may hold enough points for a seed. This spares most places the sorting. */
bool
mayHoldSeed(const OpenPoints& open, const BallPoints& ball)
{
  constexpr double rounding = 1.01;                 // of floats, which decide later
  std::array<std::size_t, neighbors + 1> nearest{}; // the middle first
  std::size_t known = 0;
  for (std::size_t k = 0; k < ball.count; ++k) {
    if (known == nearest.size() &&
        !(ball.squared[k] < ball.squared[nearest[known - 1]]))
      continue;
    known = std::min(known + 1, nearest.size());
    std::size_t at = known - 1;
    for (; at > 0 && ball.squared[k] < ball.squared[nearest[at - 1]]; --at)
      nearest[at] = nearest[at - 1];
    nearest[at] = k;
  }
  for (std::size_t n = 1; n < known; ++n) {
    const std::size_t k = nearest[n];
    const double squared = ball.squared[k];
    const Point way(ball.offset[0][k], ball.offset[1][k], ball.offset[2][k]);
    if (open.free[ball.index[k]] != 0 &&
        static_cast<double>(
            countInCylinder(ball,
                            way / std::sqrt(squared),
                            rounding * half_length * half_length * squared,
                            rounding * radius * radius * squared)) >= least_members)
      return true;
  }
  return false;
}

/** \brief The best cylinder through point \a i, with its evidence as quality. */
TrackSeed
bestSeed(const OpenPoints& open, std::size_t i, Around& found)
{
  TrackSeed best;
  best.quality = 0;
  const Point& at = open.grid.sortedPoints()[i];
  const double reach = reachOfNeighbors(open, at);
  if (!(reach > 0))
    return best;
  double visible = half_length * reach;
  BallPoints& in_ball = found.in_ball;
  findPointsAround(open.grid, at, 2 * reach, in_ball);
  if (in_ball.count <= most_points)
    findPointsAround(open.grid, at, visible, in_ball);
  if (!mayHoldSeed(open, in_ball))
    return best;
  Neighbors& around = found.nearest;
  around.clear();
  for (std::size_t k = 0; k < in_ball.count; ++k)
    around.emplace_back(in_ball.squared[k], static_cast<Index>(in_ball.index[k]));
  if (around.size() > most_points) {
    std::nth_element(around.begin(), around.begin() + most_points, around.end());
    visible = std::sqrt(around[most_points].first);
    around.resize(most_points);
  }
  // The point itself comes first.
  const std::size_t next_ones = std::min(neighbors + 1, around.size());
  std::partial_sort(around.begin(),
                    around.begin() + static_cast<std::ptrdiff_t>(next_ones),
                    around.end());
  const Offsets offsets(open, at, around);
  for (std::size_t k = 1; k < next_ones; ++k) {
    if (!open.free[around[k].second])
      continue;
    const Point next = open.grid.sortedPoints()[around[k].second] - at;
    const double distance = std::sqrt(around[k].first);
    const double half = std::min(half_length * distance, visible);
    const double wide = radius * distance;
    const Eigen::Vector3f direction = (next / distance).cast<float>();
    const InCylinder found_there(offsets,
                                 direction,
                                 static_cast<float>(half * half),
                                 static_cast<float>(wide * wide));
    const double members = found_there.members;
    if (members < least_members)
      continue;
    // Two of them define the cylinder.
    const double more = members - 2;
    const double expected = found_there.in_ball * 1.5 * wide * wide / (half * half);
    const double evidence = more * std::log(more / expected) - more + expected;
    if (evidence <= best.quality)
      continue;
    best.index = open.scene_indices[open.grid.inputIndices()[i]];
    best.at = at;
    best.direction = next / distance;
    best.radius = half;
    best.density = members / (2 * half);
    best.noise = std::sqrt(std::max(0.0F, found_there.squaresOff()) / (2 * members));
    best.quality = evidence;
  }
  best.quality = std::max(0.0, best.quality - std::log(double(neighbors)));
  return best;
}

} // namespace

std::vector<TrackSeed>
seedsAlongDirections(const TrackedScene& scene,
                     double points,
                     unsigned threads,
                     ProgressMonitor* monitor)
{
  const OpenPoints open(scene);
  const std::size_t count = open.grid.size();
  if (monitor)
    monitor->begin("sparse curves", count);
  std::vector<TrackSeed> seeds;
  // What the best of so many points would show by chance.
  const double needed = std::log(std::max(points, 1.0));
  std::mutex seeds_mutex;
  forEachChunk(count, 64, threads, [&](std::size_t begin, std::size_t end) {
    if (monitor && monitor->canceled())
      throw Canceled();
    Around around;
    for (std::size_t i = begin; i < end; ++i) {
      if (!open.free[i])
        continue;
      const TrackSeed seed = bestSeed(open, i, around);
      if (!(seed.quality > needed))
        continue;
      const std::lock_guard<std::mutex> lock(seeds_mutex);
      seeds.push_back(seed);
    }
  });
  if (monitor)
    monitor->advance(count);
  std::sort(seeds.begin(), seeds.end(), [](const auto& a, const auto& b) {
    return a.quality != b.quality ? a.quality > b.quality : a.index < b.index;
  });
  return seeds;
}

} // namespace linelet
