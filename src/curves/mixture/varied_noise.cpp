// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "varied_noise.h"

#include <algorithm>
#include <cmath>

namespace linelet {

namespace {

// At least this share of an edge's points counts, however many degrees of freedom the
// curve uses up.
constexpr double least_spare = 0.3;
// The logarithm of the noise is a random walk. The first guess of its variance over the
// whole length of a curve, and the number of steps that this guess is worth.
constexpr double first_change = 4;
constexpr double change_prior = 3;
constexpr double longest_step = 0.7; // of a logarithm, in one iteration

/** \brief Logarithm of the determinant of the precision of a random walk over \a nodes
 * places: the Laplacian of a path, or a ring, times \a stiffness, plus \a anchor. */
double
logDeterminantOfWalk(std::size_t nodes, bool closed, double stiffness, double anchor)
{
  double sum = 0;
  for (std::size_t i = 0; i < nodes; ++i) {
    const double turn =
        (closed ? 2 : 1) * M_PI * static_cast<double>(i) / static_cast<double>(nodes);
    sum += std::log(stiffness * (2 - 2 * std::cos(turn)) + anchor);
  }
  return sum;
}

} // namespace

void
measureNoise(MixtureState& mixture)
{
  if (!(mixture.noise.share > 0))
    return;
  const double spare = std::max(least_spare * mixture.noise.share,
                                mixture.noise.share - mixture.freedom);
  const double measured =
      std::sqrt(mixture.noise.square / (spare * (mixture.frame.dimensions - 1)));
  mixture.noise.deviation = std::max(
      mixture.noise.deviation * std::pow(measured / mixture.noise.deviation, stride),
      mixture.noise.least);
}

void
measureWidths(MixtureState& mixture, MixtureCurve& state, NodeSystem& system)
{
  const std::size_t n = state.width.size(), edges = state.curve.edges();
  const double parts = static_cast<double>(edges);
  if (!(state.width_change > 0))
    state.width_change = first_change;
  // Precisions of the prior: of a step between nodes, and of the common level.
  const double stiffness = parts / state.width_change;
  const double anchor = 1 / static_cast<double>(n);
  const auto after = [n](std::size_t e) { return e + 1 == n ? 0 : e + 1; };

  std::vector<double>& width = state.width;
  system.matrix.reset(n, state.curve.closed);
  system.solution.assign(n, Point::Zero()); // only one coordinate is used
  for (std::size_t e = 0; e < edges; ++e) {
    const std::size_t a = e, b = after(e);
    const MixtureEdge& edge = mixture.edges[state.first_edge + e];
    const double across = mixture.frame.dimensions - 1;
    // An end node's freedom is that of its only edge.
    const auto freedomOf = [&](std::size_t i) {
      const bool is_end = !state.curve.closed && (i == 0 || i + 1 == n);
      return state.node_freedom[i] * (is_end ? 1 : 0.5);
    };
    const double spare = std::max(least_spare * across * edge.share,
                                  across * edge.share - freedomOf(a) - freedomOf(b));
    const double scale =
        mixture.noise.deviation * edge.scale * std::exp(widthAt(state, e));
    const double square = edge.square / (scale * scale);
    // The likelihood as a function of the edge's log noise, the mean of its nodes'. The
    // curvature is the larger of Fisher's, by which a step would overshoot where points
    // lie far out, and the observed one, by which it would where they lie close.
    const double slope = 0.5 * (square - spare);
    const double curvature = 0.5 * std::max(spare, square);
    const double change = stiffness * (width[b] - width[a]);
    system.solution[a].x() += slope + change;
    system.solution[b].x() += slope - change;
    system.matrix.addDiagonal(a, curvature + stiffness);
    system.matrix.addDiagonal(b, curvature + stiffness);
    system.matrix.addNext(e, curvature - stiffness);
  }
  for (std::size_t i = 0; i < n; ++i) {
    system.matrix.addDiagonal(i, anchor);
    system.solution[i].x() -= anchor * width[i];
  }
  system.matrix.solve(system.solution);
  system.matrix.inverseBand(
      system.inverse_diagonal, system.inverse_next, system.inverse_after_next);
  for (std::size_t i = 0; i < n; ++i)
    width[i] += std::clamp(system.solution[i].x(), -longest_step, longest_step);

  mixture.noise.width_cost +=
      std::log(static_cast<double>(mixture.points)) + system.matrix.logDeterminant() -
      logDeterminantOfWalk(n, state.curve.closed, stiffness, anchor);
  for (const double w : width)
    mixture.noise.width_cost += anchor * w * w;
  double sum = change_prior * first_change / parts;
  for (std::size_t e = 0; e < edges; ++e) {
    const std::size_t a = e, b = after(e);
    const double step = width[b] - width[a];
    mixture.noise.width_cost += stiffness * step * step;
    sum += step * step + system.inverse_diagonal[a] + system.inverse_diagonal[b] -
           2 * system.inverse_next[e];
  }
  state.width_change = parts * sum / (change_prior + parts);
}

} // namespace linelet
