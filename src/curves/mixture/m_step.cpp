// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <utility>

#include "em_fit.h"
#include "em_kernels.h"

namespace linelet {

namespace {

// Points per edge that the density along a curve is drawn toward its mean with, as a
// share of the mean.
constexpr double density_prior = 0.5;
// Pull of a node to where it was, so that one without points stays determined.
constexpr double anchor = 1e-4;

} // namespace

void
EmFitter::maximize(const EmSettings& settings)
{
  freedom_ = square_ = share_ = width_cost_ = 0;
  for (CurveState& state : states_)
    maximizeCurve(state, settings);

  if (fixed_radius_ > 0)
    measureFixedRadius(settings);
  else
    measureNoise(settings);
  freedom_ *= frame_.dimensions - 1;
  if (settings.varied_noise)
    for (CurveState& state : states_)
      measureWidths(state);
  updateEdges();
  updateWeights(); // by the lengths of the edges as they are now
}

void
EmFitter::maximizeCurve(CurveState& state, const EmSettings& settings)
{
  const ModelCurve& curve = state.curve;
  system_.reset(curve.nodes.size(), curve.closed);
  pullTowardPoints(state);
  const double spacing = std::max(
      0.1 * settings.spacing, scaledLength(state) / static_cast<double>(curve.edges()));
  state.bend_mean.assign(curve.nodes.size(), Point::Zero());
  state.mean_freedom = 0;
  if (settings.even_curvature)
    measureEvenCurvature(state, spacing);
  stiffen(state, spacing);
  moveNodes(state);
  measureBending(state, spacing);
  freedom_ += state.mean_freedom;
}

void
EmFitter::pullTowardPoints(const CurveState& state)
{
  const ModelCurve& curve = state.curve;
  const std::size_t n = curve.nodes.size();
  solution_.assign(n, Point::Zero());
  data_diagonal_.assign(n, 0);
  data_next_.assign(n, 0);
  for (std::size_t e = 0; e < curve.edges(); ++e) {
    Edge& edge = edges_[state.first_edge + e];
    const std::size_t a = e, b = e + 1 == n ? 0 : e + 1;
    const EdgeSums sums =
        sumsOf(edge, !curve.closed && e == 0, !curve.closed && e + 1 == curve.edges());
    // Everything in units of the place's noise.
    const double unit = noise_ * noise_ / (edge.noise * edge.noise);
    edge.share = sums.share;
    edge.square = sums.square;
    share_ += sums.share;
    square_ += unit * sums.square;
    data_diagonal_[a] += unit * sums.aa;
    data_diagonal_[b] += unit * sums.bb;
    data_next_[e] += unit * sums.ab;
    solution_[a] += unit * Point(sums.at_a);
    solution_[b] += unit * Point(sums.at_b);
  }
  for (std::size_t i = 0; i < n; ++i) {
    system_.addDiagonal(i, data_diagonal_[i] + anchor);
    system_.addNext(i, data_next_[i]);
    solution_[i] += anchor * curve.nodes[i];
  }
}

EdgeSums
EmFitter::sumsOf(const Edge& edge, bool front, bool back)
{
  if (fixed_radius_ > 0)
    return fixedRadiusSumsOf(edge, front, back);
  return emKernels().sums(shapeOf(edge),
                          pointsOf(edge),
                          pair_density_.data() + edge.pairs_begin,
                          front,
                          back);
}

void
EmFitter::moveNodes(CurveState& state)
{
  Points& nodes = state.curve.nodes;
  system_.solve(solution_);
  system_.inverseBand(inverse_diagonal_, inverse_next_, inverse_after_next_);
  state.node_freedom.resize(nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const double freedom =
        inverse_diagonal_[i] * data_diagonal_[i] + 2 * inverse_next_[i] * data_next_[i];
    state.node_freedom[i] = (frame_.dimensions - 1) * freedom;
    freedom_ += freedom;
    nodes[i] += stride * (solution_[i] - nodes[i]);
  }
}

void
EmFitter::updateWeights()
{
  const double n = static_cast<double>(points_.size());
  for (const CurveState& state : states_) {
    const std::size_t edges = state.curve.edges();
    double total = 0;
    for (std::size_t e = 0; e < edges; ++e)
      total += edge_count_[state.first_edge + e];
    const double mean = total / static_cast<double>(edges);
    const double spacing = scaledLength(state) / static_cast<double>(edges);
    const auto half = static_cast<std::size_t>(
        std::clamp(1.5 * frame_.scale_unit / std::max(spacing, 1e-300), 1.0, 50.0));
    double all = 0;
    for (std::size_t e = 0; e < edges; ++e) {
      double sum = 0, width = 0;
      for (std::size_t k = 0; k <= 2 * half; ++k) {
        std::size_t at = e + k;
        if (state.curve.closed)
          at = (at + edges - half % edges) % edges;
        else if (at < half || at - half >= edges)
          continue;
        else
          at -= half;
        sum += edge_count_[state.first_edge + at];
        width += 1;
      }
      Edge& edge = edges_[state.first_edge + e];
      edge.weight = sum / width + density_prior * mean;
      all += edge.weight;
    }
    for (std::size_t e = 0; e < edges; ++e)
      edges_[state.first_edge + e].weight *= total / (std::max(all, 1e-300) * n);
  }
}

} // namespace linelet
