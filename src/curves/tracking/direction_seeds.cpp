// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "direction_seeds.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Core>

#include <linelet/support/threads.h>

#include "support/parallel_failure.h"

namespace linelet {

namespace {

constexpr std::size_t neighbors = 6; // the nearest; one of them is the next of a curve
// In D: where they are nearer than the first, a ball shows what there is; the other is
// that of the seeds from balls.
constexpr double sparse = 1, largest_radius = 17;
constexpr double growth = 1.4; // of the ball until it holds so many
// Of the cylinder, in distances to the neighbor: half its length, over which a curve is
// straight enough, and its radius.
constexpr double half_length = 3.5, radius = 0.1;
constexpr double least_members = 6;
constexpr std::size_t most_points = 64; // looked at around each, the nearest

/** \brief A point beside another one. */
struct Beside {
  Point offset;
  bool free; ///< no curve explains it yet
};

/** \brief The points around \a at that lie on no surface. Those of other curves count,
 * so that what these leave behind is compared with them. */
std::vector<Beside>
pointsAround(const TrackedScene& scene, const Point& at, double reach)
{
  std::vector<Beside> result;
  scene.grid.forEachRun(at, reach, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Point v = scene.points()[i] - at;
      if (!scene.surface[i] && v.squaredNorm() <= reach * reach)
        result.push_back({v, !scene.taken[i]});
    }
  });
  return result;
}

/** \brief Whether more than \ref neighbors points lie within \a reach. */
bool
isCrowded(const TrackedScene& scene, const Point& at, double reach)
{
  std::size_t count = 0;
  scene.grid.forEachRun(at, reach, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end && count <= neighbors; ++i)
      count +=
          !scene.surface[i] && (scene.points()[i] - at).squaredNorm() <= reach * reach;
  });
  return count > neighbors;
}

/** \brief Distance within which the nearest neighbors lie; 0 where they are no farther
 * than in most of the scene, or farther than a curve could be seen. */
double
reachOfNeighbors(const TrackedScene& scene, const Point& at)
{
  double reach = sparse * scene.unit;
  if (isCrowded(scene, at, reach))
    return 0;
  while (reach <= largest_radius * scene.unit) {
    reach *= growth;
    if (isCrowded(scene, at, reach))
      return reach;
  }
  return 0;
}

/** \brief Offsets as columns, for sums over all of them at once. */
struct Offsets {
  Eigen::ArrayXf x, y, z, squared, free;

  explicit Offsets(const std::vector<Beside>& points)
      : x(size(points)),
        y(size(points)),
        z(size(points)),
        squared(size(points)),
        free(size(points))
  {
    for (Eigen::Index k = 0; k < x.size(); ++k) {
      const Beside& point = points[static_cast<std::size_t>(k)];
      const Eigen::Vector3f v = point.offset.cast<float>();
      free[k] = point.free ? 1 : 0;
      x[k] = v.x();
      y[k] = v.y();
      z[k] = v.z();
      squared[k] = v.squaredNorm();
    }
  }

private:
  static Eigen::Index
  size(const std::vector<Beside>& points)
  {
    return static_cast<Eigen::Index>(points.size());
  }
};

/** \brief The best cylinder through point \a i, with its evidence as quality. */
TrackSeed
bestSeed(const TrackedScene& scene, std::size_t i)
{
  TrackSeed best;
  best.quality = 0;
  const Point& at = scene.points()[i];
  const double reach = reachOfNeighbors(scene, at);
  if (!(reach > 0))
    return best;
  double visible = half_length * reach;
  std::vector<Beside> around = pointsAround(scene, at, 2 * reach);
  if (around.size() <= most_points)
    around = pointsAround(scene, at, visible);
  const auto nearer = [](const Beside& a, const Beside& b) {
    return a.offset.squaredNorm() < b.offset.squaredNorm();
  };
  if (around.size() > most_points) {
    std::nth_element(
        around.begin(), around.begin() + most_points, around.end(), nearer);
    visible = around[most_points].offset.norm();
    around.resize(most_points);
  }
  // The point itself comes first.
  const std::size_t next_ones = std::min(neighbors + 1, around.size());
  std::partial_sort(around.begin(),
                    around.begin() + static_cast<std::ptrdiff_t>(next_ones),
                    around.end(),
                    nearer);
  const Offsets offsets(around);
  for (std::size_t k = 1; k < next_ones; ++k) {
    if (!around[k].free)
      continue;
    const Point& next = around[k].offset;
    const double distance = next.norm();
    const double half = std::min(half_length * distance, visible);
    const double wide = radius * distance;
    const Eigen::Vector3f direction = (next / distance).cast<float>();
    const auto along = direction.x() * offsets.x + direction.y() * offsets.y +
                       direction.z() * offsets.z;
    const auto inside =
        (offsets.squared <= static_cast<float>(half * half)).cast<float>();
    const Eigen::ArrayXf off = offsets.squared - along.square();
    const Eigen::ArrayXf member =
        offsets.free * inside * (off <= static_cast<float>(wide * wide)).cast<float>();
    const double members = member.sum();
    if (members < least_members)
      continue;
    // Two of them chose the cylinder, which takes this share of the ball.
    const double more = members - 2;
    const double expected = inside.sum() * 1.5 * wide * wide / (half * half);
    const double evidence = more * std::log(more / expected) - more + expected;
    if (evidence <= best.quality)
      continue;
    best.index = static_cast<Index>(i);
    best.at = at;
    best.direction = next / distance;
    best.radius = half;
    best.density = members / (2 * half);
    best.noise = std::sqrt(std::max(0.0F, (member * off).sum()) / (2 * members));
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
  const std::size_t count = scene.points().size();
  if (monitor)
    monitor->begin("sparse curves", count);
  std::vector<TrackSeed> seeds;
  // What the most of so many points would show by chance.
  const double needed = std::log(std::max(points, 1.0));
  ParallelFailure failure;
#pragma omp parallel for schedule(dynamic, 64) num_threads(threadCount(threads))
  for (std::size_t i = 0; i < count; ++i) {
    if (scene.taken[i] || scene.surface[i] || failure.failed())
      continue;
    failure.guard([&] {
      if (monitor && monitor->canceled())
        throw Canceled();
      TrackSeed seed = bestSeed(scene, i);
      if (!(seed.quality > needed))
        return;
#pragma omp critical(linelet_direction_seeds)
      seeds.push_back(seed);
    });
  }
  failure.rethrow();
  if (monitor)
    monitor->advance(count);
  std::sort(seeds.begin(), seeds.end(), [](const auto& a, const auto& b) {
    return a.quality != b.quality ? a.quality > b.quality : a.index < b.index;
  });
  return seeds;
}

} // namespace linelet
