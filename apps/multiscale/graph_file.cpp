// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "graph_file.h"

#include <cmath>
#include <cstdio>

#include <linelet/features/multi_scale.h>
#include <linelet/io/output_file.h>

namespace linelet::apps {

namespace {

constexpr const char* graph_header =
    "point,scale,radius,neighbors,linearity,planarity,sphericity,"
    "major_x,major_y,major_z\n";

/** \brief The rows of one point in the graph file. */
std::string
rowsOf(std::size_t point, const ShapeGraph& graph, const std::vector<double>& radii)
{
  std::string rows;
  char cell[64];
  for (std::size_t k = 0; k < graph.size(); ++k) {
    const ScaleShape& s = graph[k];
    std::snprintf(
        cell, sizeof(cell), "%zu,%zu,%.9g,%u", point, k, radii[k], s.neighbors);
    rows += cell;
    for (const float value :
         {s.linearity, s.planarity, s.sphericity, s.major_x, s.major_y, s.major_z}) {
      // Readers interpret an empty cell as NaN.
      std::snprintf(cell, sizeof(cell), ",%.7g", static_cast<double>(value));
      rows += std::isnan(value) ? "," : cell;
    }
    rows += '\n';
  }
  return rows;
}

} // namespace

std::vector<MultiScaleShape>
measure(const Points& points,
        const MultiScaleSettings& settings,
        const std::string& graphs,
        ProgressMonitor* monitor)
{
  if (graphs.empty())
    return multiScaleShapes(points, points, settings, {}, monitor).shapes;
  io::OutputFile file(graphs);
  file.write(graph_header);
  const auto write = [&](std::size_t point, const ShapeGraph& graph) {
    file.write(rowsOf(point, graph, settings.radii));
  };
  auto shapes = multiScaleShapes(points, points, settings, write, monitor).shapes;
  file.commit();
  return shapes;
}

} // namespace linelet::apps
