// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/features/multi_scale.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include <features/multi_scale_grid.h>
#include <features/scale_sweep.h>
#include <features/shape_summary.h>
#include <linelet/features/fourth_order.h>
#include <linelet/search/scale_unit.h>
#include <linelet/search/uniform_grid.h>
#include <linelet/support/threads.h>

namespace linelet {

namespace {

/// Queries between two deliveries of graphs: enough to keep all threads busy.
constexpr std::size_t block_size = 4096;

/// Queries handed to a thread at once.
constexpr std::size_t chunk_size = 16;

/// Rows of a quarter of the radius fit a ball well and still hold long runs.
UniformGrid
gridFor(const Points& surface, double largest_radius)
{
  return UniformGrid(surface, largest_radius / 4);
}

/// The graphs of the point whose neighbourhood \a sweep has just measured.
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

/// Runs the sweep for all queries; every thread makes itself a visitor of (query,
/// sweep).
template <class Visit>
void
sweepQueries(const UniformGrid& grid,
             const Points& queries,
             std::size_t begin,
             std::size_t end,
             const std::vector<double>& radii,
             const MultiScaleSettings& settings,
             Monitor* monitor,
             const Visit& make_visitor)
{
  std::atomic<bool> cancelled{false};
  // No more threads than there are chunks: waking a thread costs more than a few
  // queries.
  const int threads = static_cast<int>(
      std::min((end - begin + chunk_size - 1) / chunk_size,
               static_cast<std::size_t>(threadCount(settings.threads))));
#ifdef _OPENMP
#pragma omp parallel num_threads(std::max(1, threads))
#endif
  {
    ScaleSweep sweep(radii, settings);
    auto visit = make_visitor();
#ifdef _OPENMP
#pragma omp for schedule(dynamic, chunk_size)
#endif
    for (std::ptrdiff_t place = static_cast<std::ptrdiff_t>(begin);
         place < static_cast<std::ptrdiff_t>(end);
         ++place) {
      if (cancelled)
        continue;
      const auto query = static_cast<std::size_t>(place);
      sweep.clear();
      grid.forEachOffsetWithin(
          queries[query], radii.back(), [&](const Point& offset, double squared) {
            sweep.add(offset, squared);
          });
      sweep.run();
      visit(query, sweep);
      if (monitor != nullptr) {
        monitor->advance(1);
        if (monitor->cancelled())
          cancelled = true;
      }
    }
  }
  if (cancelled)
    throw Cancelled();
}

/// Largest change of a shape factor between two scales; 0 where one is not defined.
double
change(const ShapeFactors& a, const ShapeFactors& b)
{
  return std::fmax(0,
                   std::fmax(std::abs(a.linearity - b.linearity),
                             std::fmax(std::abs(a.planarity - b.planarity),
                                       std::abs(a.sphericity - b.sphericity))));
}

/// Drops the radii behind the first at which the factors of all points have converged.
void
applyStopRule(const Points& surface,
              const MultiScaleSettings& settings,
              std::vector<double>& radii,
              Monitor* monitor)
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<ShapeFactors> last(surface.size(), {nan, nan, nan});
  std::vector<double> changes(surface.size());
  for (std::size_t k = 0; k < radii.size(); ++k) {
    const std::vector<double> radius(1, radii[k]);
    const UniformGrid grid = gridFor(surface, radii[k]);
    if (monitor != nullptr)
      monitor->begin("largest radius", surface.size());
    bool any_defined = false;
    sweepQueries(grid, surface, 0, surface.size(), radius, settings, monitor, [&] {
      return [&](std::size_t query, const ScaleSweep& sweep) {
        changes[query] = change(sweep.factors()[0], last[query]);
        // A point that has just got a shape has changed.
        if (std::isnan(last[query].linearity) && !std::isnan(sweep.linearity()[0]))
          changes[query] = 1;
        last[query] = sweep.factors()[0];
      };
    });
    for (const ShapeFactors& factors : last)
      any_defined = any_defined || !std::isnan(factors.linearity);
    if (any_defined &&
        *std::max_element(changes.begin(), changes.end()) < settings.stop_change) {
      radii.resize(k + 1);
      return;
    }
  }
}

} // namespace

MultiScaleShapes
multiScaleRadii(const Points& surface,
                const MultiScaleSettings& settings,
                Monitor* monitor)
{
  if (!std::isfinite(settings.stop_change) || settings.stop_change < 0)
    throw std::invalid_argument("stop change " + std::to_string(settings.stop_change) +
                                " is not a finite number from 0 on");
  if (settings.stop_change > 0 && settings.centroid != Centroid::Mean &&
      settings.centroid != Centroid::Median)
    throw std::invalid_argument("the stop rule needs centroid mean or median: with " +
                                std::string(nameOf(settings.centroid)) +
                                " the shape factors do not converge");
  if (!std::isfinite(settings.scale_unit) || settings.scale_unit < 0)
    throw std::invalid_argument("scale unit " + std::to_string(settings.scale_unit) +
                                " is not a finite number from 0 on");

  MultiScaleShapes result;
  result.scale_unit = settings.scale_unit > 0 ? settings.scale_unit
                                              : scaleUnit(surface,
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
        radiusLadder(settings.growth, result.scale_unit, settings.max_radius);
  }
  if (settings.stop_change > 0)
    applyStopRule(surface, settings, result.radii, monitor);
  return result;
}

MultiScaleShapes
multiScaleShapes(const Points& surface,
                 const Points& queries,
                 const MultiScaleSettings& settings,
                 const ShapeGraphSink& sink,
                 Monitor* monitor)
{
  MultiScaleShapes result = multiScaleRadii(surface, settings, monitor);
  if (chosenScaleEngine(surface, queries, result.radii.back(), settings) ==
          ScaleEngine::Grid &&
      multiScaleShapesOnGrid(surface, queries, settings, sink, monitor, result))
    return result;
  result.shapes.resize(queries.size());
  const UniformGrid grid = gridFor(surface, result.radii.back());
  if (monitor != nullptr)
    monitor->begin("multi-scale", queries.size());
  const std::size_t block =
      sink ? block_size : std::max<std::size_t>(1, queries.size());
  std::vector<ShapeGraph> graphs(sink ? std::min(block, queries.size()) : 0);
  for (std::size_t begin = 0; begin < queries.size(); begin += block) {
    const std::size_t end = std::min(begin + block, queries.size());
    sweepQueries(grid, queries, begin, end, result.radii, settings, monitor, [&] {
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

std::vector<FourthOrderTensor>
fourthOrderTensors(const Points& surface,
                   const Points& queries,
                   const MultiScaleSettings& settings,
                   ScaleWeight weight,
                   Monitor* monitor)
{
  const std::vector<double> radii = multiScaleRadii(surface, settings, monitor).radii;
  std::vector<FourthOrderTensor> tensors(queries.size());
  if (monitor != nullptr)
    monitor->begin("fourth order", queries.size());
  sweepQueries(gridFor(surface, radii.back()),
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
