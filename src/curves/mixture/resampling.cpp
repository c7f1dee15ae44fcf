// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "resampling.h"

#include <algorithm>
#include <utility>

#include "curves/ridges/scale_field.h"

namespace linelet {

namespace {

constexpr double least_points = 2;

/** \brief Interpolates values at equal steps along a curve to \a count equal steps. */
std::vector<double>
stretched(const std::vector<double>& values, std::size_t count, bool closed)
{
  const std::size_t n = values.size();
  const double step = static_cast<double>(closed ? n : n - 1) /
                      static_cast<double>(closed ? count : count - 1);
  std::vector<double> result;
  for (std::size_t k = 0; k < count; ++k) {
    const double place = step * static_cast<double>(k);
    const auto i = std::min(static_cast<std::size_t>(place), n - 1);
    const double t = place - static_cast<double>(i);
    const std::size_t next = i + 1 < n ? i + 1 : closed ? 0 : n - 1;
    result.push_back((1 - t) * values[i] + t * values[next]);
  }
  return result;
}

} // namespace

void
resample(MixtureState& mixture, double spacing, const ScaleField* scales)
{
  // Each curve keeps its share of the mixture, spread evenly over its new edges.
  std::vector<double> share(mixture.curves.size());
  double total = 0;
  std::size_t kept = 0;
  for (std::size_t c = 0; c < mixture.curves.size(); ++c) {
    if (mixture.edge_count.empty())
      share[c] = length(mixture.curves[c].curve);
    else
      for (std::size_t e = 0; e < mixture.curves[c].curve.edges(); ++e)
        share[c] += mixture.edge_count[mixture.curves[c].first_edge + e];
    // A curve without points or without length is dropped.
    const bool lost = !mixture.edge_count.empty() && share[c] < least_points;
    const double narrow =
        scales ? scales->at(mixture.curves[c].curve.nodes.front()) : 1;
    if (lost || length(mixture.curves[c].curve) < spacing * std::min(1.0, narrow))
      continue;
    total += share[c];
    if (kept != c) {
      mixture.curves[kept] = std::move(mixture.curves[c]);
      share[kept] = share[c];
    }
    ++kept;
  }
  mixture.curves.resize(kept);
  mixture.edges.clear();
  for (std::size_t c = 0; c < mixture.curves.size(); ++c) {
    MixtureCurve& state = mixture.curves[c];
    const double least_edges = state.curve.closed ? 8 : 2;
    if (scales)
      state.curve = resampled(state.curve, spacing, *scales, least_edges);
    else
      state.curve =
          resampled(state.curve, std::min(spacing, length(state.curve) / least_edges));
    if (!state.width.empty())
      state.width =
          stretched(state.width, state.curve.nodes.size(), state.curve.closed);
    state.first_edge = mixture.edges.size();
    state.bend_variance.clear();
    state.bend_weight.clear();
    MixtureEdge edge;
    edge.weight = (1 - mixture.outlier_share) * share[c] /
                  (std::max(total, 1e-300) * static_cast<double>(state.curve.edges()));
    mixture.edges.insert(mixture.edges.end(), state.curve.edges(), edge);
    if (scales)
      for (std::size_t e = 0; e < state.curve.edges(); ++e)
        mixture.edges[state.first_edge + e].scale =
            scales->at(0.5 * (state.curve.from(e) + state.curve.to(e)));
  }
  mixture.updateEdges();
}

} // namespace linelet
