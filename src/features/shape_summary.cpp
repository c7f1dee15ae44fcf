// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <features/shape_summary.h>

#include <cmath>
#include <cstddef>

namespace linelet {

MultiScaleShape
summarise(const ShapeGraph& graph,
          std::uint32_t here,
          const std::vector<double>& radii,
          const LinearityGraphSettings& settings)
{
  MultiScaleShape record;
  std::vector<double> linearity;
  std::vector<std::uint32_t> neighbors;
  linearity.reserve(graph.size());
  neighbors.reserve(graph.size());
  for (const ScaleShape& shape : graph) {
    linearity.push_back(static_cast<double>(shape.linearity));
    neighbors.push_back(shape.neighbors);
    if (record.first_neighbors == 0)
      record.first_neighbors = shape.neighbors - here;
    // fmin passes over scales that are not defined.
    record.min_sphericity = std::fmin(record.min_sphericity, shape.sphericity);
  }
  const LinearityGraph reading =
      readLinearityGraph(linearity, neighbors, radii, settings);
  record.linearity_sum = static_cast<float>(reading.area);
  record.linearity_max = static_cast<float>(reading.largest);
  const std::size_t scale = reading.scale();
  if (scale == LinearityGraph::none)
    return record;
  const ScaleShape& best = graph[scale];
  record.linearity = best.linearity;
  record.planarity = best.planarity;
  record.sphericity = best.sphericity;
  record.optimal_radius = static_cast<float>(radii[scale]);
  record.blend = static_cast<float>(reading.blend);
  record.major_x = best.major_x;
  record.major_y = best.major_y;
  record.major_z = best.major_z;
  record.neighbors = best.neighbors;
  record.scale = static_cast<std::int32_t>(scale);
  return record;
}

} // namespace linelet
