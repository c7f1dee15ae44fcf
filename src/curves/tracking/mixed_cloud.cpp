// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "mixed_cloud.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <unordered_set>

#include <linelet/features/multi_scale.h>
#include <linelet/search/uniform_grid.h>

#include "surface_scales.h"

namespace linelet {

namespace {

constexpr std::size_t sample_size = 500;
constexpr std::uint32_t least_neighbors = 12; // fewer are linear by chance
constexpr double linear = 0.5;
constexpr double row_size = 4; // D

/** \brief Those of \a points within \a reach of one of \a places, and some beyond. */
Points
pointsNear(const Points& points, const Points& places, double reach)
{
  const auto cell = [reach](double x) { return std::floor(x / reach); };
  const auto key = [](double x, double y, double z) {
    const std::hash<double> hash;
    return (hash(x) * 31 + hash(y)) * 31 + hash(z);
  };
  std::unordered_set<std::size_t> cells;
  for (const Point& p : places)
    for (const double x : {cell(p.x()) - 1, cell(p.x()), cell(p.x()) + 1})
      for (const double y : {cell(p.y()) - 1, cell(p.y()), cell(p.y()) + 1})
        for (const double z : {cell(p.z()) - 1, cell(p.z()), cell(p.z()) + 1})
          cells.insert(key(x, y, z));
  Points near;
  std::copy_if(
      points.begin(), points.end(), std::back_inserter(near), [&](const Point& p) {
        return cells.count(key(cell(p.x()), cell(p.y()), cell(p.z()))) > 0;
      });
  return near;
}

} // namespace

double
linearShare(const Points& points, double unit, unsigned threads)
{
  const std::size_t count = std::min(points.size(), sample_size);
  Points sample;
  for (std::size_t k = 0; k < count; ++k)
    sample.push_back(points[k * points.size() / count]);
  MultiScaleSettings settings;
  settings.weighting = Kernel::Const;
  settings.max_radius = largest_radius * unit;
  settings.scale_unit = unit;
  settings.threads = threads;
  // Scan lines are linear, too, but their points see the surface that they lie on.
  const std::vector<double> radii = multiScaleRadii(points, settings).radii;
  const Points around = pointsNear(points, sample, settings.max_radius);
  std::vector<SurfaceScales> surfaces(count);
  multiScaleShapes(
      around, sample, settings, [&](std::size_t k, const ShapeGraph& graph) {
        surfaces[k] = surfaceScales(graph, radii);
      });
  settings.centroid = Centroid::Mean;
  std::vector<std::size_t> linear_ones;
  multiScaleShapes(
      around, sample, settings, [&](std::size_t k, const ShapeGraph& graph) {
        if (std::any_of(graph.begin(), graph.end(), [](const ScaleShape& shape) {
              return shape.neighbors >= least_neighbors && shape.linearity >= linear;
            }))
          linear_ones.push_back(k);
      });
  Points places;
  double reach = row_size * unit;
  for (const std::size_t k : linear_ones) {
    places.push_back(sample[k]);
    reach = std::max(reach, reachOf(surfaces[k]));
  }
  const UniformGrid grid(pointsNear(points, places, reach), row_size * unit);
  const auto found =
      std::count_if(linear_ones.begin(), linear_ones.end(), [&](std::size_t k) {
        return !isSurface(grid, sample[k], surfaces[k]);
      });
  return count > 0 ? static_cast<double>(found) / static_cast<double>(count) : 0;
}

} // namespace linelet
