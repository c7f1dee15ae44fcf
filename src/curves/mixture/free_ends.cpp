// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "free_ends.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "curves/ridges/scale_field.h"

namespace linelet {

bool
FreeEnds::prune(MixtureState& mixture, const EdgePairs& pairs)
{
  bool changed = false;
  const double penalty = std::log(static_cast<double>(mixture.points));
  std::size_t kept = 0;
  for (std::size_t c = 0; c < mixture.curves.size(); ++c) {
    MixtureCurve& state = mixture.curves[c];
    const std::size_t all = state.curve.edges();
    std::size_t cut[2] = {0, 0};
    for (int end = 0; end < 2; ++end) {
      if (state.curve.junction[static_cast<std::size_t>(end)] >= 0)
        continue;
      cut[end] = cheapestCut(mixture, pairs, state, end, penalty);
      if (cut[end] == all)
        break;
    }
    if (cut[0] == all || cut[1] == all || cut[0] + cut[1] + 2 > all) {
      changed = true;
      continue;
    }
    if (cut[0] + cut[1] > 0) {
      changed = true;
      Points& nodes = state.curve.nodes;
      std::vector<std::size_t>& hinges = state.curve.hinges;
      hinges.erase(std::remove_if(hinges.begin(),
                                  hinges.end(),
                                  [&](std::size_t k) {
                                    return k <= cut[0] ||
                                           k + cut[1] + 1 >= nodes.size();
                                  }),
                   hinges.end());
      for (std::size_t& k : hinges)
        k -= cut[0];
      const auto count =
          mixture.edge_count.begin() + static_cast<std::ptrdiff_t>(state.first_edge);
      // The counts of the remaining edges move to the front.
      std::copy(count + static_cast<std::ptrdiff_t>(cut[0]),
                count + static_cast<std::ptrdiff_t>(all),
                count);
      nodes.erase(nodes.end() - static_cast<std::ptrdiff_t>(cut[1]), nodes.end());
      nodes.erase(nodes.begin(), nodes.begin() + static_cast<std::ptrdiff_t>(cut[0]));
      if (!state.width.empty()) {
        auto& width = state.width;
        width.erase(width.end() - static_cast<std::ptrdiff_t>(cut[1]), width.end());
        width.erase(width.begin(), width.begin() + static_cast<std::ptrdiff_t>(cut[0]));
      }
    }
    if (kept != c)
      mixture.curves[kept] = std::move(state);
    ++kept;
  }
  mixture.curves.resize(kept);
  return changed;
}

std::size_t
FreeEnds::cheapestCut(const MixtureState& mixture,
                      const EdgePairs& pairs,
                      const MixtureCurve& state,
                      int end,
                      double penalty)
{
  const std::size_t edges = state.curve.edges();
  removed_.resize(mixture.points, 0);
  const auto n = static_cast<double>(mixture.points);
  double loss = 0, weight = 0, freedom = 0, best = 0;
  std::size_t best_cut = 0;
  std::size_t done = 0;
  for (; done < edges; ++done) {
    const std::size_t e = end == 0 ? done : edges - 1 - done;
    const MixtureEdge& edge = mixture.edges[state.first_edge + e];
    double left = 1; // product of the remaining fractions of the points' densities
    for (std::size_t k = edge.pairs_begin; k < edge.pairs_end; ++k) {
      double& gone = removed_[pairs.index[k]];
      const double before = std::max(1e-12, 1 - gone);
      gone += pairs.density[k];
      left *= std::max(1e-12, 1 - gone) / before;
      if (left < 1e-200) {
        loss += std::log(left);
        left = 1;
      }
    }
    loss += std::log(left);
    weight += edge.weight;
    freedom +=
        state.node_freedom[end == 0 ? done : state.node_freedom.size() - 1 - done];
    const bool whole = done + 1 == edges;
    // Part of a curve is removed only if that improves the likelihood itself.
    if ((state.curve.closed && !whole) || (whole && mixture.curves.size() == 1))
      continue;
    const double change = -2 * (loss - n * std::log(std::max(1e-12, 1 - weight))) -
                          (whole ? (freedom + 4) * penalty : 0);
    if (change < best) {
      best = change;
      best_cut = done + 1;
    }
  }
  for (std::size_t e = 0; e < edges; ++e) {
    const MixtureEdge& edge = mixture.edges[state.first_edge + e];
    for (std::size_t k = edge.pairs_begin; k < edge.pairs_end; ++k)
      removed_[pairs.index[k]] = 0;
  }
  return best_cut;
}

void
FreeEnds::extend(MixtureState& mixture, double spacing, const ScaleField* scales)
{
  for (MixtureCurve& state : mixture.curves)
    for (int end = 0; end < 2 && !state.curve.closed; ++end) {
      if (state.curve.junction[static_cast<std::size_t>(end)] >= 0)
        continue;
      Point& tip = end == 0 ? state.curve.nodes.front() : state.curve.nodes.back();
      const double step = spacing * (scales ? scales->at(tip) : 1);
      tip += step * outwardDirection(state.curve, end, 3 * step);
    }
}

} // namespace linelet
