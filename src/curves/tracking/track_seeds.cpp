// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "track_seeds.h"

#include <algorithm>
#include <cmath>

#include <linelet/features/multi_scale.h>

#include "support/parallel_chunks.h"
#include "surface_scales.h"

namespace linelet {

namespace {

// Points per area of the best sampled surfaces of a scene, as a quantile over the
// points on surfaces, and the share of it below which a surface is sparse. Wires side
// by side had .07 to .25 of it in scenes of two simulators; so have walls.
constexpr double best_sampled = 0.95, sparse_share = 0.3;

TrackSeed
seedAt(std::size_t i, const Point& at, const ScaleShape& shape, double radius)
{
  TrackSeed seed;
  seed.index = static_cast<Index>(i);
  seed.at = at;
  seed.direction = Point(shape.major_x, shape.major_y, shape.major_z);
  seed.radius = radius;
  seed.density = shape.neighbors / (2 * radius);
  // For a line through its middle, l3 is r^2 / 3; the query has as much noise as the
  // neighbors around it.
  const double least = shape.sphericity / 3, middle = least + shape.planarity / 2;
  const double most = 1 - least - middle;
  seed.noise = radius * std::sqrt((least + middle) / (4 * 3 * most));
  seed.quality = shape.linearity * (1 - 1 / std::sqrt(double(shape.neighbors)));
  return seed;
}

/** \brief Points of \a scene on surfaces whose \a density is far below that of
 * others. */
Indices
sparseSurfaces(const TrackedScene& scene, const std::vector<float>& density)
{
  std::vector<float> sorted;
  for (std::size_t i = 0; i < density.size(); ++i)
    if (scene.surface[i] != 0)
      sorted.push_back(density[i]);
  Indices result;
  if (sorted.empty())
    return result;
  const auto best = sorted.begin() + static_cast<std::ptrdiff_t>(
                                         best_sampled * double(sorted.size() - 1));
  std::nth_element(sorted.begin(), best, sorted.end());
  for (std::size_t i = 0; i < density.size(); ++i)
    if (scene.surface[i] != 0 && density[i] < sparse_share * *best)
      result.push_back(static_cast<Index>(i));
  return result;
}

} // namespace

SceneSeeds
measureScene(TrackedScene& scene, unsigned threads, ProgressMonitor* monitor)
{
  const Points& points = scene.points();
  std::vector<TrackSeed> seeds;
  MultiScaleSettings settings;
  settings.weighting = Kernel::Const;
  settings.max_radius = largest_radius * scene.unit;
  settings.scale_unit = scene.unit;
  settings.threads = threads;
  const std::vector<double> radii = multiScaleRadii(points, settings).radii;
  struct Doubtful {
    Index index;
    SurfaceScales scales;
  };
  std::vector<Doubtful> doubtful;
  std::vector<float> density(points.size(), 0); // of the surface through the point
  const auto sink = [&](std::size_t i, const ShapeGraph& graph) {
    const SurfaceScales surface = surfaceScales(graph, radii);
    if (surface.any) {
      scene.surface[i] = 1;
      density[i] = static_cast<float>(surface.density);
      if (!surface.isDoubtful())
        return;
      doubtful.push_back({static_cast<Index>(i), surface});
    }
    std::size_t finest = graph.size(), coarsest = graph.size();
    for (std::size_t k = 0; k < graph.size(); ++k)
      if (graph[k].linearity >= linear_ball && graph[k].neighbors >= least_linear) {
        coarsest = k;
        if (finest == graph.size())
          finest = k;
      }
    if (finest == graph.size())
      return;
    seeds.push_back(seedAt(i, points[i], graph[finest], radii[finest]));
    if (coarsest > finest + 1)
      seeds.push_back(seedAt(i, points[i], graph[coarsest], radii[coarsest]));
  };
  multiScaleShapes(points, points, settings, sink, monitor);
  forEachChunk(doubtful.size(), 64, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k)
      scene.surface[doubtful[k].index] =
          isSurface(scene.grid, points[doubtful[k].index], doubtful[k].scales);
  });
  std::sort(seeds.begin(), seeds.end(), [](const auto& a, const auto& b) {
    if (a.quality != b.quality)
      return a.quality > b.quality;
    return a.index != b.index ? a.index < b.index : a.radius < b.radius;
  });
  SceneSeeds result;
  result.sparse_surfaces = sparseSurfaces(scene, density);
  for (const TrackSeed& seed : seeds) {
    if (scene.surface[seed.index] == 0)
      result.open.push_back(seed);
    else if (std::binary_search(result.sparse_surfaces.begin(),
                                result.sparse_surfaces.end(),
                                seed.index))
      result.on_sparse_surfaces.push_back(seed);
  }
  return result;
}

} // namespace linelet
