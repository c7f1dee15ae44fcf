// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "model_network.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "junctions.h"

namespace linelet {

namespace {

// In bandwidths. Ends that the tracing attached may have moved in the refit; others
// attach within the distance at which a trace would have.
constexpr double attached_distance = 2;
constexpr double attach_distance = 0.8;
constexpr double loop_length = 5;
// Vertices of the result per node of the fit: an edge across a junction belongs to
// neither curve, so it should be short.
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
  result.reserve(support.size());
  for (const double count : support)
    result.push_back(static_cast<Index>(std::lround(count)));
  return result;
}

/** \brief \a curve with every edge divided into \ref finer parts. */
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

} // namespace

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
    if (!coarse.counts.empty()) {
      curve.noise = coarse.noise;
      curve.density = std::accumulate(coarse.counts.begin(), coarse.counts.end(), 0.0) /
                      length(coarse);
      curve.evidence = coarse.evidence;
    }
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

} // namespace linelet
