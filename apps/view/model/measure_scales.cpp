// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "measure_scales.h"

#include <algorithm>
#include <cstddef>

namespace linelet::view {

namespace {

/// Most bytes of graphs to keep.
constexpr std::size_t most_graphs = std::size_t{1} << 30;

} // namespace

MultiScaleShapes
measureScales(const Points& points,
              MultiScaleSettings settings,
              GraphStore* store,
              ProgressMonitor* monitor)
{
  const MultiScaleShapes plan = multiScaleRadii(points, settings, monitor);
  settings.radii = plan.radii;
  settings.stop_change = 0; // already applied to the radii
  settings.engine = chosenScaleEngine(points, points, plan.radii.back(), settings);
  const std::size_t scales = plan.radii.size();
  ShapeGraphSink sink;
  if (store != nullptr && points.size() * scales * sizeof(ScaleShape) <= most_graphs) {
    store->radii = plan.radii;
    store->shapes.resize(points.size() * scales);
    sink = [=](std::size_t point, const ShapeGraph& graph) {
      std::copy(graph.begin(),
                graph.end(),
                store->shapes.begin() + static_cast<std::ptrdiff_t>(point * scales));
    };
  }
  MultiScaleShapes result = multiScaleShapes(points, points, settings, sink, monitor);
  result.scale_unit = plan.scale_unit;
  return result;
}

} // namespace linelet::view
