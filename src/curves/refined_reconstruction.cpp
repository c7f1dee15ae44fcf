// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/curves/refined_reconstruction.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <exception>
#include <iterator>
#include <numeric>
#include <stdexcept>
#include <utility>

#include <linelet/curves/junction_bridging.h>
#include <linelet/curves/junction_network.h>
#include <linelet/curves/refined_part.h>
#include <linelet/search/scale_unit.h>
#include <linelet/support/text.h>
#include <linelet/support/threads.h>

#include "occupied_cells.h"

namespace linelet {

namespace {

// All in D.
constexpr double link_distance = 5; // of one connected part
constexpr double near_gap = 2.5;    // bridged whatever the length
constexpr double end_reach = 3;     // over which the direction of an end is taken
// In bandwidths. Ends that the tracing attached to others lie where the refit has left
// them, others within the distance at which a trace would have been attached.
constexpr double attached_distance = 2;
constexpr double attach_distance = 0.8;
constexpr double loop_length = 5;

constexpr std::size_t least_part = 5;
// The spacing of so many points is looked at, and followed where it varies by more than
// this along the curves.
constexpr std::size_t most_varied = 60000;
constexpr double uneven = 2.5;
constexpr std::size_t most_in_cell = 100; // of side D
// Vertices of the result per node of the fit: an edge across a junction is told by its
// vertices to belong to neither curve, so it had better be short.
constexpr std::size_t finer = 3;

/** \brief Half the points of each edge to each of its vertices. */
std::vector<Index>
supportOf(const ModelCurve& curve, const ModelCurve& coarse)
{
  std::vector<double> support(curve.nodes.size(), 0);
  for (std::size_t e = 0; e < curve.edges(); ++e) {
    const double share = 0.5 * coarse.counts[std::min(e / finer, coarse.edges() - 1)] /
                         static_cast<double>(finer);
    support[e] += share;
    support[e + 1 == curve.nodes.size() ? 0 : e + 1] += share;
  }
  std::vector<Index> result;
  for (const double count : support)
    result.push_back(static_cast<Index>(std::lround(count)));
  return result;
}

/** \brief \a curve with every edge in so many parts. */
ModelCurve
finely(const ModelCurve& curve)
{
  ModelCurve result = curve;
  result.nodes.clear();
  for (std::size_t e = 0; e < curve.edges(); ++e)
    for (std::size_t k = 0; k < finer; ++k)
      result.nodes.emplace_back(curve.from(e) + static_cast<double>(k) / finer *
                                                    (curve.to(e) - curve.from(e)));
  if (!curve.closed)
    result.nodes.push_back(curve.nodes.back());
  return result;
}

/** \brief \a curve with free ends that reach past the last points it explains by half
 * their mean distance, as far as it is on average from the last point to the end. */
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

CurveNetwork
networkOf(const ModelCurves& curves)
{
  CurveNetwork network;
  std::vector<std::array<EndReach, 2>> reaches;
  for (const ModelCurve& coarse : curves) {
    if (coarse.edges() == 0)
      continue;
    const ModelCurve model = finely(coarse);
    Curve curve;
    curve.points = model.nodes;
    curve.closed = model.closed;
    curve.front.kind = curve.back.kind =
        model.closed ? EndKind::Loop : EndKind::Support;
    if (coarse.counts.size() == coarse.edges())
      curve.support = supportOf(model, coarse);
    network.curves.push_back(std::move(curve));
    reaches.emplace_back();
    for (std::size_t end = 0; end < 2; ++end)
      reaches.back()[end] = {coarse.scale * (coarse.junction[end] >= 0
                                                 ? attached_distance
                                                 : attach_distance),
                             coarse.scale * loop_length};
  }
  connectEnds(network, reaches);
  return network;
}

/** \brief The finite points without those that lie on others. */
Points
distinct(const Points& points)
{
  Points result;
  std::copy_if(points.begin(),
               points.end(),
               std::back_inserter(result),
               [](const Point& p) { return p.allFinite(); });
  std::sort(result.begin(), result.end(), [](const Point& a, const Point& b) {
    return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
  });
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

/** \brief Whether all finite points coincide. */
bool
coincide(const Points& points)
{
  const auto first = std::find_if(
      points.begin(), points.end(), [](const Point& p) { return p.allFinite(); });
  return std::none_of(first, points.end(), [&](const Point& p) {
    return p.allFinite() && p != *first;
  });
}

/** \brief At most \ref most_in_cell points of every cell of side \a size; their
 * indices, ascending. Points crowded far beyond the spacing of the others would
 * otherwise each look at all of the crowd. */
Indices
thinned(const Points& points, double size)
{
  const OccupiedCells cells = occupiedCells(points, size);
  Indices kept;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    // Spread evenly over the order of the input.
    const std::size_t begin = cells.begin[c], count = cells.begin[c + 1] - begin;
    const std::size_t most = std::min(count, most_in_cell);
    for (std::size_t k = 0; k < most; ++k)
      kept.push_back(cells.indices[begin + k * count / most]);
  }
  std::sort(kept.begin(), kept.end());
  return kept;
}

} // namespace

CurveNetwork
reconstructRefined(const Points& all, const RefinedSettings& settings, Monitor* monitor)
{
  if (!(settings.distance_cutoff >= 0))
    throw std::invalid_argument(
        "distance cutoff " + textOf(settings.distance_cutoff) +
        " is negative or not a number; 0 lets the method choose");
  CurveNetwork network;
  if (coincide(all))
    return network;
  const double scale_unit = scaleUnit(all, 1024, 1, settings.threads);
  if (scale_unit == 0) { // most points lie on others
    const Points different = distinct(all);
    if (different.size() < all.size())
      return reconstructRefined(different, settings, monitor);
  }
  if (!(scale_unit > 0) || !std::isfinite(scale_unit))
    return network;
  const double link = settings.distance_cutoff > 0 ? settings.distance_cutoff
                                                   : link_distance * scale_unit;
  Points thin;
  for (const Index i : thinned(all, scale_unit))
    thin.push_back(all[i]);
  const Points& points = thin.size() < all.size() ? thin : all;
  ScaleField scales;
  if (points.size() <= most_varied)
    scales = ScaleField(points, scale_unit);
  const bool varied = scales.spread() > uneven;
  const std::vector<Indices> parts =
      connectedParts(points, link, least_part, varied ? &scales : nullptr);
  std::vector<EmFit> fits(parts.size());
  if (monitor)
    monitor->begin("curves", points.size());
  std::atomic<bool> stopped{false};
  std::exception_ptr failure;
  const auto stop = [&] {
    if (monitor && monitor->cancelled())
      stopped = true;
    return stopped.load();
  };
#pragma omp parallel for schedule(dynamic) num_threads(threadCount(settings.threads))
  for (std::size_t p = 0; p < parts.size(); ++p) {
    if (stop())
      continue;
    std::size_t told = 0; // to the monitor, of this part
    try {
      Points part;
      part.reserve(parts[p].size());
      const Point origin = points[parts[p].front()];
      for (const Index i : parts[p])
        part.push_back(points[i] - origin);
      const ScaleField local = scales.from(origin);
      fits[p] = refinePart(
          part, settings, varied ? &local : nullptr, stop, [&](double share) {
            if (stop())
              throw Cancelled();
            const auto now = static_cast<std::size_t>(
                std::min(1.0, share) * static_cast<double>(parts[p].size()));
            if (monitor && now > told) {
              monitor->advance(now - told);
              told = now;
            }
          });
      for (ModelCurve& curve : fits[p].curves)
        for (Point& node : curve.nodes)
          node += origin;
    }
    catch (...) {
#pragma omp critical(linelet_refined_failure)
      failure = std::current_exception();
      stopped = true;
    }
    if (monitor)
      monitor->advance(parts[p].size() - told);
  }
  if (failure)
    std::rethrow_exception(failure);
  if (stopped)
    throw Cancelled();
  ModelCurves curves;
  for (EmFit& fit : fits)
    for (std::size_t c = 0; c < fit.curves.size(); ++c) {
      fit.curves[c].counts = std::move(fit.counts[c]);
      curves.push_back(extended(fit.curves[c]));
    }
  return networkOf(bridgeGaps(
      curves, near_gap * scale_unit, settings.distance_cutoff, end_reach * scale_unit));
}

} // namespace linelet
