// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "neighborhood.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <linelet/features/read_linearity_graph.h>
#include <linelet/features/tensor_record.h>

namespace linelet::view {

namespace {

/// Up to this many points, a click builds a search over all of them: that takes only a
/// moment, and sums keep the order of a run over the whole cloud.
constexpr std::size_t few_points = 4000000;

/** \brief The points of \a scene within \a reach of a box around \a places, in order:
 * graphs there depend only on these. */
Points
surfaceAround(const Scene& scene, const Points& places, double reach)
{
  Box box;
  box.low.setConstant(std::numeric_limits<double>::infinity());
  box.high = -box.low;
  for (const Point& p : places) {
    box.low = box.low.cwiseMin(p);
    box.high = box.high.cwiseMax(p);
  }
  const Point middle = (box.low + box.high) / 2;
  const double radius = (box.high - box.low).norm() / 2 + reach;
  Points surface;
  if (scene.grid == nullptr || places.empty())
    return surface;
  Indices found = scene.grid->within(middle, radius * (1 + 1e-9));
  std::sort(found.begin(), found.end());
  surface.reserve(found.size());
  for (const Index i : found)
    surface.push_back(scene.points[i]);
  return surface;
}

MultiScaleSettings
inDouble(const std::vector<double>& radii, MultiScaleSettings settings)
{
  settings.radii = radii;
  settings.stop_change = 0; // already applied to the radii
  settings.scale_unit = 1;  // not needed with given radii
  settings.engine = ScaleEngine::Sweep;
  return settings;
}

std::vector<ShapeGraph>
graphsOf(const Points& surface,
         const Points& queries,
         const std::vector<double>& radii,
         const MultiScaleSettings& settings,
         std::vector<MultiScaleShape>& shapes,
         ProgressMonitor* monitor)
{
  std::vector<ShapeGraph> graphs(queries.size());
  shapes = multiScaleShapes(
               surface,
               queries,
               inDouble(radii, settings),
               [&](std::size_t i, const ShapeGraph& graph) { graphs[i] = graph; },
               monitor)
               .shapes;
  return graphs;
}

LinearityGraph
readingOf(const ShapeGraph& graph,
          const std::vector<double>& radii,
          const LinearityGraphSettings& settings)
{
  std::vector<double> linearity;
  std::vector<std::uint32_t> neighbors;
  for (const ScaleShape& shape : graph) {
    linearity.push_back(static_cast<double>(shape.linearity));
    neighbors.push_back(shape.neighbors);
  }
  return readLinearityGraph(linearity, neighbors, radii, settings);
}

PointGraphs::Spread
spreadAt(const std::vector<ShapeGraph>& graphs, std::size_t scale)
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  PointGraphs::Spread spread{};
  for (int factor = 0; factor < 3; ++factor) {
    double sum = 0, squares = 0, count = 0;
    for (const ShapeGraph& graph : graphs) {
      const ScaleShape& s = graph[scale];
      const auto value = static_cast<double>(factor == 0   ? s.linearity
                                             : factor == 1 ? s.planarity
                                                           : s.sphericity);
      if (std::isnan(value))
        continue;
      sum += value;
      squares += value * value;
      count += 1;
    }
    spread.mean[factor] = count > 0 ? sum / count : nan;
    spread.deviation[factor] =
        count > 0 ? std::sqrt(std::max(0.0, squares / count - std::pow(sum / count, 2)))
                  : nan;
  }
  return spread;
}

} // namespace

PointGraphs
graphsAt(const Scene& scene,
         Index point,
         const std::vector<double>& radii,
         const MultiScaleSettings& settings,
         const GraphStore* store,
         ProgressMonitor* monitor)
{
  constexpr std::size_t most_neighbors = 64;
  PointGraphs result;
  result.radii = radii;
  const Points here = {scene.points.at(point)};
  std::vector<MultiScaleShape> shapes;
  if (store != nullptr) {
    result.graph = store->of(point);
    result.stored = true;
  }
  else
    result.graph = graphsOf(scene.points.size() <= few_points
                                ? scene.points
                                : surfaceAround(scene, here, radii.back()),
                            here,
                            radii,
                            settings,
                            shapes,
                            monitor)
                       .front();
  result.reading = readingOf(result.graph, radii, settings.graph);
  result.scale = result.reading.scale();
  const double around = result.ownRadius() > 0 ? result.ownRadius() : radii.front();
  const Indices found = scene.grid->within(scene.points[point], around);
  std::vector<ShapeGraph> graphs;
  Points neighbors;
  const std::size_t kept = std::min(found.size(), most_neighbors);
  for (std::size_t i = 0; i < kept; ++i) {
    const Index neighbor = found[i * found.size() / kept];
    if (store != nullptr)
      graphs.push_back(store->of(neighbor));
    else
      neighbors.push_back(scene.points[neighbor]);
  }
  if (!neighbors.empty())
    graphs = graphsOf(surfaceAround(scene, neighbors, radii.back()),
                      neighbors,
                      radii,
                      settings,
                      shapes,
                      monitor);
  for (std::size_t k = 0; k < radii.size() && kept > 0; ++k)
    result.spread.push_back(spreadAt(graphs, k));
  return result;
}

ScaleImage
scaleImageAlong(const Scene& scene,
                const Points& line,
                std::size_t columns,
                const std::vector<double>& radii,
                const MultiScaleSettings& settings,
                ProgressMonitor* monitor)
{
  ScaleImage image;
  image.radii = radii;
  double total = 0;
  for (std::size_t i = 1; i < line.size(); ++i)
    total += (line[i] - line[i - 1]).norm();
  if (line.empty() || columns == 0)
    return image;
  std::size_t edge = 1;
  double before = 0;
  for (std::size_t c = 0; c < columns; ++c) {
    const double s = total * static_cast<double>(c) /
                     static_cast<double>(std::max<std::size_t>(columns - 1, 1));
    while (edge + 1 < line.size() &&
           before + (line[edge] - line[edge - 1]).norm() < s) {
      before += (line[edge] - line[edge - 1]).norm();
      ++edge;
    }
    Point at = line.front();
    if (line.size() > 1) {
      const Point step = line[edge] - line[edge - 1];
      const double length = step.norm();
      at = line[edge - 1] +
           (length > 0 ? std::min(1.0, (s - before) / length) : 0.0) * step;
    }
    image.along.push_back(s);
    image.places.push_back(at);
  }
  image.columns = graphsOf(surfaceAround(scene, image.places, radii.back()),
                           image.places,
                           radii,
                           settings,
                           image.shapes,
                           monitor);
  return image;
}

ScaleImage
scaleImageAround(const Scene& scene,
                 Index point,
                 double radius,
                 const Point& axis,
                 std::size_t columns,
                 const std::vector<double>& radii,
                 const MultiScaleSettings& settings,
                 ProgressMonitor* monitor)
{
  ScaleImage image;
  image.radii = radii;
  const Point& center = scene.points.at(point);
  std::vector<std::pair<double, Index>> found;
  scene.grid->forEachWithin(center, radius, [&](Index i, double) {
    found.emplace_back((scene.points[i] - center).dot(axis), i);
  });
  std::sort(found.begin(), found.end());
  const std::size_t kept = std::min(found.size(), columns);
  for (std::size_t c = 0; c < kept; ++c) {
    const auto& [along, i] = found[c * found.size() / kept];
    image.along.push_back(along);
    image.places.push_back(scene.points[i]);
  }
  if (kept > 0)
    image.columns = graphsOf(surfaceAround(scene, image.places, radii.back()),
                             image.places,
                             radii,
                             settings,
                             image.shapes,
                             monitor);
  return image;
}

PointDistributionTensor
tensorAt(const Scene& scene, Index point, double radius, TensorSettings settings)
{
  settings.radius = radius;
  settings.k = 0;
  Indices found = scene.grid->within(scene.points.at(point), radius);
  std::sort(found.begin(), found.end());
  Points offsets;
  for (const Index i : found)
    offsets.push_back(scene.points[i] - scene.points[point]);
  return tensorOf(offsets, radius, settings);
}

std::vector<std::size_t>
distanceHistogram(const Scene& scene, Index point, double radius, std::size_t bins)
{
  std::vector<std::size_t> counts(bins, 0);
  scene.grid->forEachWithin(
      scene.points.at(point), radius, [&](Index i, double squared) {
        const double place = std::sqrt(squared) / radius * static_cast<double>(bins);
        if (i != point)
          ++counts[std::min(static_cast<std::size_t>(place), bins - 1)];
      });
  return counts;
}

} // namespace linelet::view
