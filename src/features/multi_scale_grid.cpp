// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <features/multi_scale_grid.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <features/shape_summary.h>
#include <linelet/features/grid_tensor_engine.h>
#include <linelet/search/uniform_grid.h>

namespace linelet {

namespace {

/// Queries whose graphs are held at once: 80 MB at eleven scales.
constexpr std::size_t block_size = std::size_t{1} << 18;

void
put(const PointDistributionTensor& record, std::uint32_t here, ScaleShape& shape)
{
  shape.neighbors = record.neighbors;
  // One neighbour beside the point spans a line whatever the shape of the cloud.
  if (record.neighbors < here + 2)
    return;
  shape.linearity = record.linearity;
  shape.planarity = record.planarity;
  shape.sphericity = record.sphericity;
  shape.major_x = record.major_x;
  shape.major_y = record.major_y;
  shape.major_z = record.major_z;
}

} // namespace

ScaleEngine
chosenScaleEngine(const Points& surface,
                  const Points& queries,
                  double largest_radius,
                  const MultiScaleSettings& settings)
{
  // On a wire with 325 neighbours the grid takes a half to a quarter of the time,
  // with medians as much as the sweep. Few points keep all their digits, as nobody
  // waits for them.
  constexpr std::size_t samples = 64, few = 300, least_points = 1000,
                        least_queries = 256;
  if (settings.engine != ScaleEngine::Auto)
    return settings.engine;
  if (queries.size() < least_queries || surface.size() < least_points)
    return ScaleEngine::Sweep;
  const UniformGrid grid(surface, largest_radius / 4);
  const std::size_t step = (queries.size() + samples - 1) / samples;
  std::size_t neighbors = 0, count = 0;
  for (std::size_t i = 0; i < queries.size(); i += step, ++count)
    neighbors += grid.countWithin(queries[i], largest_radius);
  return neighbors > few * count ? ScaleEngine::Grid : ScaleEngine::Sweep;
}

void
multiScaleShapesOnGrid(const Points& surface,
                       const Points& queries,
                       const MultiScaleSettings& settings,
                       const ShapeGraphSink& sink,
                       Monitor* monitor,
                       MultiScaleShapes& result)
{
  TensorSettings pass;
  pass.weighting = settings.weighting;
  pass.centroid = settings.centroid;
  pass.centroid_weighting = settings.centroid_weighting;
  pass.threads = settings.threads;
  const std::vector<double>& radii = result.radii;
  const UniformGrid places(surface, radii.front());

  result.shapes.resize(queries.size());
  for (std::size_t begin = 0; begin < queries.size(); begin += block_size) {
    const std::size_t end = std::min(begin + block_size, queries.size());
    const Points block(queries.begin() + static_cast<std::ptrdiff_t>(begin),
                       queries.begin() + static_cast<std::ptrdiff_t>(end));
    std::vector<ShapeGraph> graphs(block.size(), ShapeGraph(radii.size()));
    std::vector<std::uint32_t> here;
    here.reserve(block.size());
    for (const Point& query : block)
      here.push_back(static_cast<std::uint32_t>(places.countWithin(query, 0)));
    for (std::size_t k = 0; k < radii.size(); ++k) {
      pass.radius = radii[k];
      const std::vector<PointDistributionTensor> records =
          estimateTensorsOnGrid(surface, block, pass, {}, monitor);
      for (std::size_t i = 0; i < block.size(); ++i)
        put(records[i], here[i], graphs[i][k]);
    }
    for (std::size_t i = 0; i < block.size(); ++i) {
      result.shapes[begin + i] = summarise(graphs[i], here[i], radii, settings.graph);
      if (sink)
        sink(begin + i, graphs[i]);
    }
  }
}

} // namespace linelet
