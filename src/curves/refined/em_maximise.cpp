// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <utility>

#include "em_fit.h"
#include "em_kernels.h"

namespace linelet {

namespace {

// Points per edge that the density along a curve is drawn towards its mean with, as a
// share of the mean.
constexpr double density_prior = 0.5;
constexpr double tail = 3; // degrees of freedom of the bending prior
// Bends that the first guess of the prior's scale counts for.
constexpr double bending_prior = 3;
// Pull of a node to where it was, so that one without points stays determined.
constexpr double anchor = 1e-4;

/** \brief Inverse variance of the second differences under the prior. */
double
rigidityOf(double bending, double spacing)
{
  return 1 / (bending * spacing * spacing * spacing);
}

/** \brief Number of bends; bend i lies over node i and the two after it. */
std::size_t
bendsOf(const ModelCurve& curve)
{
  const std::size_t n = curve.nodes.size();
  return curve.closed ? n : n < 3 ? 0 : n - 2;
}

/** \brief The two nodes after node \a i, around the ring. */
std::pair<std::size_t, std::size_t>
nextNodes(const ModelCurve& curve, std::size_t i)
{
  const std::size_t n = curve.nodes.size();
  return {i + 1 < n ? i + 1 : i + 1 - n, i + 2 < n ? i + 2 : i + 2 - n};
}

/** \brief Square of the second difference at bend \a i. */
double
squaredBend(const ModelCurve& curve, std::size_t i)
{
  const auto [j, k] = nextNodes(curve, i);
  return (curve.nodes[i] - 2 * curve.nodes[j] + curve.nodes[k]).squaredNorm();
}

} // namespace

void
EmFitter::maximise(const EmSettings& settings)
{
  freedom_ = square_ = share_ = width_cost_ = 0;
  for (CurveState& state : states_)
    maximiseCurve(state, settings);

  if (shell_ > 0)
    measureShell(settings);
  else
    measureNoise(settings);
  freedom_ *= frame_.dimensions - 1;
  if (settings.varied_noise)
    for (CurveState& state : states_)
      measureWidths(state);
  updateEdges();
  updateWeights();
}

void
EmFitter::maximiseCurve(CurveState& state, const EmSettings& settings)
{
  const ModelCurve& curve = state.curve;
  system_.reset(curve.nodes.size(), curve.closed);
  pullTowardsPoints(state);
  const double spacing = std::max(
      0.1 * settings.spacing, scaledLength(state) / static_cast<double>(curve.edges()));
  stiffen(state, spacing);
  moveNodes(state);
  measureBending(state, spacing);
}

void
EmFitter::pullTowardsPoints(const CurveState& state)
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
  if (shell_ > 0)
    return shellSumsOf(edge, front, back);
  return emKernels().sums(shapeOf(edge),
                          pointsOf(edge),
                          pair_density_.data() + edge.pairs_begin,
                          front,
                          back);
}

double
EmFitter::bendUnit(const CurveState& state, std::size_t i) const
{
  const double scale = edges_[state.first_edge + i].scale;
  return 1 / (scale * scale);
}

void
EmFitter::stiffen(const CurveState& state, double spacing)
{
  const ModelCurve& curve = state.curve;
  const double rigidity = rigidityOf(state.bending, spacing);
  const std::size_t bends = bendsOf(curve);
  const bool known = state.bend_variance.size() == bends;
  const double across = frame_.dimensions - 1;
  bend_weight_.resize(bends);
  for (std::size_t i = 0; i < bends; ++i) {
    const auto [j, k] = nextNodes(curve, i);
    if (std::binary_search(curve.hinges.begin(), curve.hinges.end(), j)) {
      bend_weight_[i] = 0;
      continue;
    }
    const double unit = bendUnit(state, i);
    double square = squaredBend(curve, i);
    if (known)
      square += across * state.bend_variance[i];
    // A Student distribution is a normal one that a greater bend makes wider.
    bend_weight_[i] = (tail + across) / (tail + rigidity * square * unit);
    const double w = noise_ * noise_ * rigidity * bend_weight_[i] * unit;
    system_.addDiagonal(i, w);
    system_.addDiagonal(j, 4 * w);
    system_.addDiagonal(k, w);
    system_.addNext(i, -2 * w);
    system_.addNext(j, -2 * w);
    system_.addAfterNext(i, w);
  }
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

double
EmFitter::bendVariance(const ModelCurve& curve, std::size_t i) const
{
  const auto [j, k] = nextNodes(curve, i);
  return noise_ * noise_ *
         std::max(0.0,
                  inverse_diagonal_[i] + 4 * inverse_diagonal_[j] +
                      inverse_diagonal_[k] - 4 * inverse_next_[i] -
                      4 * inverse_next_[j] + 2 * inverse_after_next_[i]);
}

void
EmFitter::measureBending(CurveState& state, double spacing)
{
  // The scale of the prior: that at which its bends and what is unknown of them are as
  // wide as it says (MacKay). Expectation maximisation has the same fixed point and
  // creeps.
  const double rigidity = rigidityOf(state.bending, spacing);
  const std::size_t bends = bendsOf(state.curve);
  const double across = frame_.dimensions - 1;
  const double first_square = bending_prior * across * state.first_bending;
  double square = 0, known_bends = bending_prior;
  state.bend_variance.resize(bends);
  for (std::size_t i = 0; i < bends; ++i) {
    const double unit = bendUnit(state, i), weight = bend_weight_[i];
    const double variance = bendVariance(state.curve, i);
    state.bend_variance[i] = variance;
    square += weight * squaredBend(state.curve, i) * unit;
    if (weight > 0)
      known_bends += std::max(0.0, 1 - rigidity * weight * variance * unit);
  }
  state.bending =
      (first_square + square / (spacing * spacing * spacing)) / (known_bends * across);
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
