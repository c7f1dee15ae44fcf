// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "component_curves.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <functional>
#include <numeric>
#include <utility>
#include <vector>

#include <linelet/support/threads.h>

#include "curves/network/bridging.h"
#include "curves/ridges/connected_components.h"
#include "refine_component.h"
#include "support/parallel_failure.h"

namespace linelet {

namespace {

// All in D.
constexpr double link_distance = 5; // of one connected component
constexpr double near_gap = 2.5;    // bridged whatever the length
constexpr double end_reach = 3;     // the stretch that gives the direction of an end

// Only up to this many points, local spacing is measured, and followed where it varies
// by more than this factor along the curves.
constexpr std::size_t most_varied = 60000;
constexpr double uneven = 2.5;

/** \brief The fit of one component, computed near the origin to keep precision.
 * \param[in] scales of all points; null: not followed */
EmFit
refineNearOrigin(const Points& points,
                 const Indices& indices,
                 const RefinedSettings& settings,
                 const ScaleField* scales,
                 const std::function<bool()>& stop,
                 const std::function<void(double)>& progress)
{
  Points component;
  component.reserve(indices.size());
  const Point& origin = points[indices.front()];
  for (const Index i : indices)
    component.push_back(points[i] - origin);
  const ScaleField local = scales ? scales->from(origin) : ScaleField();
  EmFit fit =
      refineComponent(component, settings, scales ? &local : nullptr, stop, progress);
  for (ModelCurve& curve : fit.curves)
    for (Point& node : curve.nodes)
      node += origin;
  return fit;
}

/** \brief The fits of all components, in order, whatever the number of threads. */
std::vector<EmFit>
refineComponents(const Points& points,
                 const std::vector<Indices>& components,
                 const RefinedSettings& settings,
                 const ScaleField* scales,
                 ProgressMonitor* monitor)
{
  std::vector<EmFit> fits(components.size());
  if (monitor)
    monitor->begin("curves", points.size());
  std::atomic<bool> stopped{false};
  ParallelFailure failure;
  const auto stop = [&] {
    if (monitor && monitor->canceled())
      stopped = true;
    return stopped.load();
  };
#pragma omp parallel for schedule(dynamic) num_threads(threadCount(settings.threads))
  for (std::size_t p = 0; p < components.size(); ++p) {
    if (stop())
      continue;
    std::size_t told = 0; // progress of this component reported so far
    const auto progress = [&](double share) {
      if (stop())
        throw Canceled();
      const auto now = static_cast<std::size_t>(
          std::min(1.0, share) * static_cast<double>(components[p].size()));
      if (monitor && now > told) {
        monitor->advance(now - told);
        told = now;
      }
    };
    failure.guard([&] {
      fits[p] =
          refineNearOrigin(points, components[p], settings, scales, stop, progress);
    });
    if (failure.failed())
      stopped = true;
    if (monitor)
      monitor->advance(components[p].size() - told);
  }
  failure.rethrow();
  if (stopped)
    throw Canceled();
  return fits;
}

/** \brief \a curve with its free ends extended past the last explained points by half
 * their mean distance, which is how far the end lies from the last point on average. */
ModelCurve
extended(const ModelCurve& curve)
{
  ModelCurve result = curve;
  const double points = std::accumulate(curve.counts.begin(), curve.counts.end(), 0.0);
  if (curve.closed || !(points > 1))
    return result;
  const double step = 0.5 * length(curve) / points;
  for (int end = 0; end < 2; ++end)
    if (curve.junction[static_cast<std::size_t>(end)] < 0)
      (end == 0 ? result.nodes.front() : result.nodes.back()) +=
          step * outwardDirection(curve, end, 3 * step);
  return result;
}

} // namespace

ModelCurves
componentCurves(const Points& points,
                const NeighborSearch* search,
                double scale_unit,
                const RefinedSettings& settings,
                ProgressMonitor* monitor)
{
  const double link = settings.distance_cutoff > 0 ? settings.distance_cutoff
                                                   : link_distance * scale_unit;
  ScaleField field;
  if (points.size() <= most_varied)
    field = ScaleField(points, scale_unit, uneven, search);
  const ScaleField* scales = field.spread() > uneven ? &field : nullptr;
  const std::vector<Indices> components =
      connectedComponents(points, link, least_component, scales);
  ModelCurves curves;
  for (EmFit& fit : refineComponents(points, components, settings, scales, monitor)) {
    double total = 0;
    for (const std::vector<double>& counts : fit.counts)
      total = std::accumulate(counts.begin(), counts.end(), total);
    for (std::size_t c = 0; c < fit.curves.size(); ++c) {
      ModelCurve& curve = fit.curves[c];
      curve.counts = std::move(fit.counts[c]);
      curve.noise = fit.spread;
      curve.evidence = fit.evidence *
                       std::accumulate(curve.counts.begin(), curve.counts.end(), 0.0) /
                       total;
      curves.push_back(extended(curve));
    }
  }
  return bridgeGaps(
      curves, near_gap * scale_unit, settings.distance_cutoff, end_reach * scale_unit);
}

} // namespace linelet
