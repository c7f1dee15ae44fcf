// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/curves/refined_reconstruction.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <stdexcept>

#include <linelet/curves/refined_part.h>
#include <linelet/search/scale_unit.h>
#include <linelet/support/threads.h>

namespace linelet {

namespace {

constexpr double link_distance = 5; // of one connected part, in D
constexpr std::size_t least_part = 5;
// Vertices of the result per node of the fit: an edge across a junction is told by its
// vertices to belong to neither curve, so it had better be short.
constexpr std::size_t finer = 3;

void
append(CurveNetwork& network, EmFit& fit)
{
  for (std::size_t c = 0; c < fit.curves.size(); ++c) {
    const ModelCurve& coarse = fit.curves[c];
    if (coarse.edges() == 0)
      continue;
    const ModelCurve model =
        resampled(coarse, length(coarse) / static_cast<double>(finer * coarse.edges()));
    Curve curve;
    curve.closed = model.closed;
    curve.front.kind = curve.back.kind =
        model.closed ? EndKind::Loop : EndKind::Support;
    // An edge's points are spread over its parts, half to each vertex.
    std::vector<double> support(model.nodes.size(), 0);
    for (std::size_t e = 0; e < model.edges(); ++e) {
      const double share = 0.5 *
                           fit.counts[c][std::min(e / finer, coarse.edges() - 1)] /
                           static_cast<double>(finer);
      support[e] += share;
      support[e + 1 == model.nodes.size() ? 0 : e + 1] += share;
    }
    for (const double count : support)
      curve.support.push_back(static_cast<Index>(std::lround(count)));
    curve.points = model.nodes;
    network.curves.push_back(std::move(curve));
  }
}

} // namespace

CurveNetwork
reconstructRefined(const Points& points,
                   const RefinedSettings& settings,
                   Monitor* monitor)
{
  if (!(settings.distance_cutoff >= 0))
    throw std::invalid_argument(
        "distance cutoff " + std::to_string(settings.distance_cutoff) +
        " is negative or not a number; 0 lets the method choose");
  CurveNetwork network;
  const double scale_unit = scaleUnit(points, 1024, 1, settings.threads);
  if (!(scale_unit > 0) || !std::isfinite(scale_unit))
    return network;
  const double link = settings.distance_cutoff > 0 ? settings.distance_cutoff
                                                   : link_distance * scale_unit;
  const std::vector<Indices> parts = connectedParts(points, link, least_part);
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
    try {
      Points part;
      part.reserve(parts[p].size());
      const Point origin = points[parts[p].front()];
      for (const Index i : parts[p])
        part.push_back(points[i] - origin);
      fits[p] = refinePart(part, settings, stop);
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
      monitor->advance(parts[p].size());
  }
  if (failure)
    std::rethrow_exception(failure);
  if (stopped)
    throw Cancelled();
  for (EmFit& fit : fits)
    append(network, fit);
  return network;
}

} // namespace linelet
