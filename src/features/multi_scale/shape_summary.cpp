// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <features/multi_scale/shape_summary.h>

#include <cmath>

namespace linelet {

ShapeSummary::ShapeSummary(const std::vector<double>& radii,
                           const LinearityGraphSettings& settings)
    : radii_(radii),
      reader_(radii, settings),
      linearity_(radii.size()),
      neighbors_(radii.size())
{
}

MultiScaleShape
ShapeSummary::operator()(const GraphColumns& graph, std::uint32_t here)
{
  MultiScaleShape record;
  for (std::size_t k = 0; k < radii_.size(); ++k) {
    const std::size_t place = k * graph.stride;
    linearity_[k] = static_cast<double>(graph.linearity[place]);
    neighbors_[k] = graph.neighbors[place];
    if (record.first_neighbors == 0)
      record.first_neighbors = neighbors_[k] - here;
    // False for scales that are not defined.
    const float sphericity = graph.sphericity[place];
    if (std::isnan(record.min_sphericity) || sphericity < record.min_sphericity)
      record.min_sphericity = sphericity;
  }
  const LinearityGraph& reading = reader_.read(linearity_, neighbors_);
  record.linearity_sum = static_cast<float>(reading.area);
  record.linearity_max = static_cast<float>(reading.largest);
  const std::size_t scale = reading.scale();
  if (scale == LinearityGraph::none)
    return record;
  const std::size_t best = scale * graph.stride;
  record.linearity = graph.linearity[best];
  record.planarity = graph.planarity[best];
  record.sphericity = graph.sphericity[best];
  record.optimal_radius = static_cast<float>(radii_[scale]);
  record.blend = static_cast<float>(reading.blend);
  record.neighbors = graph.neighbors[best];
  record.scale = static_cast<std::int32_t>(scale);
  return record;
}

} // namespace linelet
