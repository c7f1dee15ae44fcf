// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>

#include "em_fit.h"

namespace linelet {

namespace {

// Of the points of an edge, so large a share counts at least, whatever the curve's
// freedom takes away.
constexpr double least_spare = 0.3;
// The logarithm of the noise is a random walk. The first guess of its variance over the
// whole length of a curve, and the steps that this guess counts for.
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
EmFitter::measureNoise(const EmSettings& settings)
{
  if (!(share_ > 0))
    return;
  const double spare = std::max(least_spare * share_, share_ - freedom_);
  const double measured = std::sqrt(square_ / (spare * (frame_.dimensions - 1)));
  noise_ = std::max(noise_ * std::pow(measured / noise_, stride), settings.least_noise);
}

/** \brief The logarithm of the noise of edge \a e beside that of all. */
double
EmFitter::widthAt(const CurveState& state, std::size_t e) const
{
  if (state.width.empty())
    return 0;
  return 0.5 * (state.width[e] + state.width[e + 1 == state.width.size() ? 0 : e + 1]);
}

void
EmFitter::measureWidths(CurveState& state)
{
  const std::size_t n = state.width.size(), edges = state.curve.edges();
  const double parts = static_cast<double>(edges);
  if (!(state.width_change > 0))
    state.width_change = first_change;
  // Of the prior: of a step between nodes, and of the level of all.
  const double stiffness = parts / state.width_change;
  const double anchor = 1 / static_cast<double>(n);
  const auto after = [n](std::size_t e) { return e + 1 == n ? 0 : e + 1; };

  std::vector<double>& width = state.width;
  system_.reset(n, state.curve.closed);
  solution_.assign(n, Point::Zero()); // of one coordinate
  for (std::size_t e = 0; e < edges; ++e) {
    const std::size_t a = e, b = after(e);
    const Edge& edge = edges_[state.first_edge + e];
    const double across = frame_.dimensions - 1;
    // An end node's freedom is that of its only edge.
    const auto freedomOf = [&](std::size_t i) {
      const bool is_end = !state.curve.closed && (i == 0 || i + 1 == n);
      return state.node_freedom[i] * (is_end ? 1 : 0.5);
    };
    const double spare = std::max(least_spare * across * edge.share,
                                  across * edge.share - freedomOf(a) - freedomOf(b));
    const double scale = noise_ * edge.scale * std::exp(widthAt(state, e));
    const double square = edge.square / (scale * scale);
    // The likelihood in the edge's logarithm, which is the mean of its nodes'; where
    // the points lie far out its own curvature would leap, and where near, Fisher's.
    const double slope = 0.5 * (square - spare);
    const double curvature = 0.5 * std::max(spare, square);
    const double change = stiffness * (width[b] - width[a]);
    solution_[a].x() += slope + change;
    solution_[b].x() += slope - change;
    system_.addDiagonal(a, curvature + stiffness);
    system_.addDiagonal(b, curvature + stiffness);
    system_.addNext(e, curvature - stiffness);
  }
  for (std::size_t i = 0; i < n; ++i) {
    system_.addDiagonal(i, anchor);
    solution_[i].x() -= anchor * width[i];
  }
  system_.solve(solution_);
  system_.inverseBand(inverse_diagonal_, inverse_next_, inverse_after_next_);
  for (std::size_t i = 0; i < n; ++i)
    width[i] += std::clamp(solution_[i].x(), -longest_step, longest_step);

  width_cost_ += std::log(static_cast<double>(points_.size())) +
                 system_.logDeterminant() -
                 logDeterminantOfWalk(n, state.curve.closed, stiffness, anchor);
  for (const double w : width)
    width_cost_ += anchor * w * w;
  double sum = change_prior * first_change / parts;
  for (std::size_t e = 0; e < edges; ++e) {
    const std::size_t a = e, b = after(e);
    const double step = width[b] - width[a];
    width_cost_ += stiffness * step * step;
    sum += step * step + inverse_diagonal_[a] + inverse_diagonal_[b] -
           2 * inverse_next_[e];
  }
  state.width_change = parts * sum / (change_prior + parts);
}

} // namespace linelet
