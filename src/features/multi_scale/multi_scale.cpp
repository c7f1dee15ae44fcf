// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/features/multi_scale.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include <features/multi_scale/multi_scale_grid.h>
#include <features/multi_scale/shape_summary.h>
#include <features/multi_scale/stop_rule.h>
#include <features/multi_scale/sweep_queries.h>
#include <features/scale_sweep.h>
#include <linelet/features/fourth_order.h>
#include <linelet/search/scale_unit.h>
#include <linelet/support/text.h>

namespace linelet {

namespace {

/// Queries between two deliveries of graphs: enough to keep all threads busy.
constexpr std::size_t block_size = 4096;

/// The graphs of the point whose neighborhood \a sweep has just measured.
ShapeGraph
graphOf(const ScaleSweep& sweep)
{
  ShapeGraph graph(sweep.factors().size());
  for (std::size_t k = 0; k < graph.size(); ++k) {
    ScaleShape& shape = graph[k];
    shape.neighbors = sweep.neighbors()[k];
    const ShapeFactors& factors = sweep.factors()[k];
    if (std::isnan(factors.linearity))
      continue;
    const Eigen::Vector3f major = sweep.majors()[k].cast<float>();
    shape.linearity = static_cast<float>(factors.linearity);
    shape.planarity = static_cast<float>(factors.planarity);
    shape.sphericity = static_cast<float>(factors.sphericity);
    shape.major_x = major.x();
    shape.major_y = major.y();
    shape.major_z = major.z();
  }
  return graph;
}

MultiScaleShape
recordOf(const ShapeGraph& graph, const ScaleSweep& sweep, ShapeSummary& summary)
{
  static_assert(sizeof(ScaleShape) == 7 * sizeof(float));
  const ScaleShape& first = graph.front();
  MultiScaleShape record =
      summary({&first.linearity,
               &first.planarity,
               &first.sphericity,
               &first.neighbors,
               sizeof(ScaleShape) / sizeof(float)},
              sweep.neighbors().back() - sweep.neighborsBeside().back());
  if (record.scale >= 0) {
    const ScaleShape& best = graph[static_cast<std::size_t>(record.scale)];
    record.major_x = best.major_x;
    record.major_y = best.major_y;
    record.major_z = best.major_z;
  }
  return record;
}

/// As the functions of the same names in the header; \a search may be null.
MultiScaleShapes
radiiFor(const NeighborSearch* search,
         const Points& surface,
         const MultiScaleSettings& settings,
         ProgressMonitor* monitor)
{
  checkWeightings(settings.centroid, settings.weighting, settings.centroid_weighting);
  if (!std::isfinite(settings.stop_change) || settings.stop_change < 0)
    throw std::invalid_argument("stop change " + textOf(settings.stop_change) +
                                " is negative or not finite");
  if (settings.stop_change > 0 && settings.centroid != Centroid::Mean &&
      settings.centroid != Centroid::Median)
    throw std::invalid_argument("the stop rule needs centroid mean or median: with " +
                                std::string(nameOf(settings.centroid)) +
                                " the shape factors do not converge");
  if (!std::isfinite(settings.scale_unit) || settings.scale_unit < 0)
    throw std::invalid_argument("scale unit " + textOf(settings.scale_unit) +
                                " is negative or not finite");

  MultiScaleShapes result;
  if (settings.scale_unit > 0)
    result.scale_unit = settings.scale_unit;
  else if (search != nullptr)
    result.scale_unit = scaleUnit(*search,
                                  surface,
                                  settings.scale_unit_sample,
                                  settings.scale_unit_seed,
                                  settings.threads);
  else
    result.scale_unit = scaleUnit(surface,
                                  settings.scale_unit_sample,
                                  settings.scale_unit_seed,
                                  settings.threads);
  if (!settings.radii.empty()) {
    checkRadii(settings.radii);
    result.radii = settings.radii;
  }
  else {
    if (!(result.scale_unit > 0))
      throw std::invalid_argument(
          "the points have no scale unit D (fewer than two, or most of them in one "
          "place); give the radii or a scale unit");
    result.radii =
        radiusSequence(settings.growth, result.scale_unit, settings.max_radius);
  }
  if (settings.stop_change > 0)
    applyStopRule(search, surface, settings, result.radii, monitor);
  return result;
}

MultiScaleShapes
shapesOf(const NeighborSearch* search,
         const Points& surface,
         const Points& queries,
         const MultiScaleSettings& settings,
         const ShapeGraphSink& sink,
         ProgressMonitor* monitor)
{
  MultiScaleShapes result = radiiFor(search, surface, settings, monitor);
  if (search == nullptr &&
      chosenScaleEngine(surface, queries, result.radii.back(), settings) ==
          ScaleEngine::Grid &&
      multiScaleShapesOnGrid(
          surface, queries, nullptr, settings, sink, monitor, result))
    return result;
  result.shapes.resize(queries.size());
  const SweepNeighbors neighbors(surface, result.radii.back(), search);
  if (monitor != nullptr)
    monitor->begin("multi-scale", queries.size());
  const std::size_t block =
      sink ? block_size : std::max<std::size_t>(1, queries.size());
  std::vector<ShapeGraph> graphs(sink ? std::min(block, queries.size()) : 0);
  for (std::size_t begin = 0; begin < queries.size(); begin += block) {
    const std::size_t end = std::min(begin + block, queries.size());
    sweepQueries(neighbors, queries, begin, end, result.radii, settings, monitor, [&] {
      return [&, summary = ShapeSummary(result.radii, settings.graph)](
                 std::size_t query, const ScaleSweep& sweep) mutable {
        ShapeGraph graph = graphOf(sweep);
        result.shapes[query] = recordOf(graph, sweep, summary);
        if (sink)
          graphs[query - begin] = std::move(graph);
      };
    });
    if (sink)
      for (std::size_t query = begin; query < end; ++query)
        sink(query, graphs[query - begin]);
  }
  return result;
}

} // namespace

MultiScaleShapes
multiScaleRadii(const Points& surface,
                const MultiScaleSettings& settings,
                ProgressMonitor* monitor)
{
  return radiiFor(nullptr, surface, settings, monitor);
}

MultiScaleShapes
multiScaleRadii(const NeighborSearch& search,
                const Points& surface,
                const MultiScaleSettings& settings,
                ProgressMonitor* monitor)
{
  return radiiFor(&search, surface, settings, monitor);
}

MultiScaleShapes
multiScaleShapes(const Points& surface,
                 const Points& queries,
                 const MultiScaleSettings& settings,
                 const ShapeGraphSink& sink,
                 ProgressMonitor* monitor)
{
  return shapesOf(nullptr, surface, queries, settings, sink, monitor);
}

MultiScaleShapes
multiScaleShapes(const NeighborSearch& search,
                 const Points& surface,
                 const Points& queries,
                 const MultiScaleSettings& settings,
                 const ShapeGraphSink& sink,
                 ProgressMonitor* monitor)
{
  return shapesOf(&search, surface, queries, settings, sink, monitor);
}

std::vector<FourthOrderTensor>
fourthOrderTensors(const Points& surface,
                   const Points& queries,
                   const MultiScaleSettings& settings,
                   ScaleWeight weight,
                   ProgressMonitor* monitor)
{
  const std::vector<double> radii = multiScaleRadii(surface, settings, monitor).radii;
  std::vector<FourthOrderTensor> tensors;
  if (chosenScaleEngine(surface, queries, radii.back(), settings) ==
          ScaleEngine::Grid &&
      fourthOrderTensorsOnGrid(
          surface, queries, radii, settings, weight, monitor, tensors))
    return tensors;
  tensors.resize(queries.size());
  if (monitor != nullptr)
    monitor->begin("fourth order", queries.size());
  sweepQueries(SweepNeighbors(surface, radii.back()),
               queries,
               0,
               queries.size(),
               radii,
               settings,
               monitor,
               [&] {
                 return [&](std::size_t query, const ScaleSweep& sweep) {
                   tensors[query] = fourthOrderTensor(sweep.tensors(), weight);
                 };
               });
  return tensors;
}

} // namespace linelet
