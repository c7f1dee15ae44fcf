// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "mixed_cloud.h"

#include <algorithm>

#include <linelet/features/multi_scale.h>
#include <linelet/search/uniform_grid.h>

#include "surface_scales.h"

namespace linelet {

namespace {

constexpr std::size_t sample_size = 500;
constexpr double largest_radius = 17;         // D
constexpr std::uint32_t least_neighbors = 12; // fewer are linear by chance
constexpr double linear = 0.5;
constexpr double row_size = 4; // D

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
  // Scan lines are linear, too; that a surface runs through them shows from their own.
  const std::vector<double> radii = multiScaleRadii(points, settings).radii;
  std::vector<SurfaceScales> surfaces(count);
  multiScaleShapes(
      points, sample, settings, [&](std::size_t k, const ShapeGraph& graph) {
        surfaces[k] = surfaceScales(graph, radii);
      });
  const UniformGrid grid(points, row_size * unit);
  settings.centroid = Centroid::Mean;
  std::size_t found = 0;
  multiScaleShapes(
      points, sample, settings, [&](std::size_t k, const ShapeGraph& graph) {
        const bool is_linear =
            std::any_of(graph.begin(), graph.end(), [](const ScaleShape& shape) {
              return shape.neighbors >= least_neighbors && shape.linearity >= linear;
            });
        found += is_linear && !isSurface(grid, sample[k], surfaces[k]);
      });
  return count > 0 ? static_cast<double>(found) / static_cast<double>(count) : 0;
}

} // namespace linelet
