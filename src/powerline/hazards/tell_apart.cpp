// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/hazards/tell_apart.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>

#include <linelet/features/multi_scale.h>
#include <linelet/search/uniform_grid.h>
#include <linelet/support/threads.h>

namespace linelet::powerline {

namespace {

constexpr double voxel = 0.7;     // meters, one query each
constexpr double smoothing = 2.5; // meters, the smallest width of a roof
constexpr double least_planarity = 0.5, least_single = 0.6, least_linearity = 0.9,
                 stiff_linearity = 0.7;
const std::vector<double> radii = {1, 1.5, 2.2}; // meters, of roofs and of crowns

/** The shape around a place. */
struct Shape {
  double planarity = 0, linearity = 0; // largest over the radii; that of the largest
};

std::vector<Shape>
shapesAt(const Points& surface, const Points& queries, unsigned threads)
{
  MultiScaleSettings settings;
  settings.radii = radii;
  settings.scale_unit = 1; // radii are given
  settings.threads = threads;
  std::vector<Shape> shapes(queries.size());
  multiScaleShapes(
      surface, queries, settings, [&](std::size_t query, const ShapeGraph& graph) {
        Shape& shape = shapes[query];
        for (const ScaleShape& sample : graph) {
          if (sample.planarity == sample.planarity)
            shape.planarity = std::max<double>(shape.planarity, sample.planarity);
          if (sample.linearity == sample.linearity)
            shape.linearity = sample.linearity;
        }
      });
  return shapes;
}

} // namespace

std::vector<bool>
tellApart(Surroundings& all,
          const Indices& unknown,
          const std::vector<bool>& single,
          unsigned threads)
{
  std::vector<bool> lines(all.points.size(), false);
  if (unknown.empty())
    return lines;
  // One query per voxel, with the share of single echoes in it.
  std::unordered_map<std::uint64_t, std::size_t> voxels;
  std::vector<std::size_t> voxel_of(unknown.size());
  Points queries;
  std::vector<double> singles, counts;
  for (std::size_t k = 0; k < unknown.size(); ++k) {
    const Point& p = all.points[unknown[k]];
    const auto part = [&](int axis, int bits) {
      return static_cast<std::uint64_t>(
                 static_cast<std::int64_t>(std::floor(p[axis] / voxel))) &
             ((std::uint64_t(1) << bits) - 1);
    };
    const std::uint64_t key = part(0, 24) << 40 | part(1, 24) << 16 | part(2, 16);
    const auto [at, fresh] = voxels.emplace(key, queries.size());
    voxel_of[k] = at->second;
    if (fresh) {
      queries.push_back(p);
      singles.push_back(0);
      counts.push_back(0);
    }
    singles[at->second] += single[unknown[k]] ? 1 : 0;
    counts[at->second] += 1;
  }
  const std::vector<Shape> shapes = shapesAt(all.points, queries, threads);

  const UniformGrid grid(queries, smoothing);
  std::vector<std::uint8_t> building(queries.size());
  const auto n = static_cast<std::ptrdiff_t>(queries.size());
#pragma omp parallel for schedule(dynamic, 256) num_threads(threadCount(threads))
  for (std::ptrdiff_t q = 0; q < n; ++q) {
    double planar = 0, linear = 0, alone = 0, number = 0, around = 0;
    grid.forEachWithin(
        queries[static_cast<std::size_t>(q)], smoothing, [&](Index j, double) {
          planar += shapes[j].planarity;
          linear += shapes[j].linearity;
          around += 1;
          alone += singles[j];
          number += counts[j];
        });
    // Roofs are planar nearly everywhere and stop every pulse, masts and booms are
    // linear nearly everywhere; crowns are neither.
    building[static_cast<std::size_t>(q)] =
        (planar / around > least_planarity && alone / number > least_single) ||
                linear / around > stiff_linearity
            ? 1
            : 0;
  }
  for (std::size_t k = 0; k < unknown.size(); ++k) {
    if (building[voxel_of[k]] != 0)
      all.kinds[unknown[k]] = HazardKind::Building;
    lines[unknown[k]] = shapes[voxel_of[k]].linearity > least_linearity;
  }
  return lines;
}

} // namespace linelet::powerline
