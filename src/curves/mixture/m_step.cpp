// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "m_step.h"

#include <algorithm>
#include <cmath>

#include "bending_prior.h"
#include "straightening.h"
#include "varied_noise.h"

namespace linelet {

namespace {

// Weight, as a share of the mean number of points per edge, with which the density
// along a curve is pulled toward its mean.
constexpr double density_prior = 0.5;
// Pull of a node toward its last position, which keeps nodes without points determined.
constexpr double anchor = 1e-4;

EdgeSums
sumsOf(const MixtureState& mixture,
       const MixtureEdge& edge,
       EdgePairs& pairs,
       const FixedRadiusNoise& fixed_radius,
       bool front,
       bool back)
{
  if (mixture.noise.fixed_radius > 0)
    return fixed_radius.sums(mixture, edge, pairs, front, back);
  return emKernels().sums(shapeOf(edge),
                          pairs.pointsOf(edge),
                          pairs.density.data() + edge.pairs_begin,
                          front,
                          back);
}

/** \brief Adds the pull of the points on the nodes of a curve to \a system. */
void
pullTowardPoints(MixtureState& mixture,
                 const MixtureCurve& state,
                 EdgePairs& pairs,
                 const FixedRadiusNoise& fixed_radius,
                 NodeSystem& system)
{
  const ModelCurve& curve = state.curve;
  const std::size_t n = curve.nodes.size();
  system.solution.assign(n, Point::Zero());
  system.data_diagonal.assign(n, 0);
  system.data_next.assign(n, 0);
  for (std::size_t e = 0; e < curve.edges(); ++e) {
    MixtureEdge& edge = mixture.edges[state.first_edge + e];
    const std::size_t a = e, b = e + 1 == n ? 0 : e + 1;
    const EdgeSums sums = sumsOf(mixture,
                                 edge,
                                 pairs,
                                 fixed_radius,
                                 !curve.closed && e == 0,
                                 !curve.closed && e + 1 == curve.edges());
    // Everything in units of the local noise.
    const double unit =
        mixture.noise.deviation * mixture.noise.deviation / (edge.noise * edge.noise);
    edge.share = sums.share;
    edge.square = sums.square;
    mixture.noise.share += sums.share;
    mixture.noise.square += unit * sums.square;
    system.data_diagonal[a] += unit * sums.aa;
    system.data_diagonal[b] += unit * sums.bb;
    system.data_next[e] += unit * sums.ab;
    system.solution[a] += unit * Point(sums.at_a);
    system.solution[b] += unit * Point(sums.at_b);
  }
  for (std::size_t i = 0; i < n; ++i) {
    system.matrix.addDiagonal(i, system.data_diagonal[i] + anchor);
    system.matrix.addNext(i, system.data_next[i]);
    system.solution[i] += anchor * curve.nodes[i];
  }
}

/** \brief Solves \a system, and measures how free each node is. */
void
moveNodes(MixtureState& mixture, MixtureCurve& state, NodeSystem& system)
{
  Points& nodes = state.curve.nodes;
  system.matrix.solve(system.solution);
  system.matrix.inverseBand(
      system.inverse_diagonal, system.inverse_next, system.inverse_after_next);
  state.node_freedom.resize(nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const double freedom = system.inverse_diagonal[i] * system.data_diagonal[i] +
                           2 * system.inverse_next[i] * system.data_next[i];
    state.node_freedom[i] = (mixture.frame.dimensions - 1) * freedom;
    mixture.freedom += freedom;
    nodes[i] += stride * (system.solution[i] - nodes[i]);
  }
}

void
maximizeCurve(MixtureState& mixture,
              MixtureCurve& state,
              EdgePairs& pairs,
              const FixedRadiusNoise& fixed_radius,
              NodeSystem& system,
              const EmSettings& settings,
              bool may_straighten)
{
  const ModelCurve& curve = state.curve;
  system.matrix.reset(curve.nodes.size(), curve.closed);
  pullTowardPoints(mixture, state, pairs, fixed_radius, system);
  if (may_straighten)
    straighten(mixture, state, system);
  const double spacing =
      std::max(0.1 * settings.spacing,
               mixture.scaledLength(state) / static_cast<double>(curve.edges()));
  state.bend_mean.assign(curve.nodes.size(), Point::Zero());
  state.mean_freedom = 0;
  if (settings.even_curvature && !state.straight)
    measureEvenCurvature(mixture, state, spacing);
  stiffen(mixture, state, spacing, system);
  moveNodes(mixture, state, system);
  measureBending(mixture, state, spacing, system);
  mixture.freedom += state.mean_freedom;
}

void
updateWeights(MixtureState& mixture)
{
  const double n = static_cast<double>(mixture.points);
  for (const MixtureCurve& state : mixture.curves) {
    const std::size_t edges = state.curve.edges();
    double total = 0;
    for (std::size_t e = 0; e < edges; ++e)
      total += mixture.edge_count[state.first_edge + e];
    const double mean = total / static_cast<double>(edges);
    const double spacing = mixture.scaledLength(state) / static_cast<double>(edges);
    const auto half = static_cast<std::size_t>(std::clamp(
        1.5 * mixture.frame.scale_unit / std::max(spacing, 1e-300), 1.0, 50.0));
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
        sum += mixture.edge_count[state.first_edge + at];
        width += 1;
      }
      MixtureEdge& edge = mixture.edges[state.first_edge + e];
      edge.weight = sum / width + density_prior * mean;
      all += edge.weight;
    }
    for (std::size_t e = 0; e < edges; ++e)
      mixture.edges[state.first_edge + e].weight *= total / (std::max(all, 1e-300) * n);
  }
}

} // namespace

void
maximize(MixtureState& mixture,
         EdgePairs& pairs,
         const FixedRadiusNoise& fixed_radius,
         NodeSystem& system,
         const EmSettings& settings,
         bool may_straighten)
{
  mixture.freedom = mixture.noise.square = mixture.noise.share =
      mixture.noise.width_cost = 0;
  for (MixtureCurve& state : mixture.curves)
    maximizeCurve(
        mixture, state, pairs, fixed_radius, system, settings, may_straighten);

  if (mixture.noise.fixed_radius > 0)
    fixed_radius.measure(mixture, pairs);
  else
    measureNoise(mixture);
  mixture.freedom *= mixture.frame.dimensions - 1;
  if (settings.varied_noise)
    for (MixtureCurve& state : mixture.curves)
      measureWidths(mixture, state, system);
  mixture.updateEdges();
  updateWeights(mixture); // by the current lengths of the edges
}

} // namespace linelet
