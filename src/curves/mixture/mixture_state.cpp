// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "mixture_state.h"

#include <algorithm>
#include <cmath>

namespace linelet {

double
MixtureState::scaledLength(const MixtureCurve& state) const
{
  double sum = 0;
  for (std::size_t e = 0; e < state.curve.edges(); ++e)
    sum += edges[state.first_edge + e].length / edges[state.first_edge + e].scale;
  return sum;
}

void
MixtureState::updateEdges()
{
  for (const MixtureCurve& state : curves)
    for (std::size_t e = 0; e < state.curve.edges(); ++e) {
      MixtureEdge& edge = edges[state.first_edge + e];
      edge.from = state.curve.from(e);
      const Point chord = state.curve.to(e) - edge.from;
      edge.length = std::max(chord.norm(), 1e-12 * frame.diagonal);
      edge.direction = chord / edge.length;
      const double here = state.width.empty()
                              ? noise.deviation
                              : noise.deviation * std::exp(widthAt(state, e));
      edge.noise = std::max(here, noise.least) * edge.scale;
    }
}

double
widthAt(const MixtureCurve& state, std::size_t e)
{
  if (state.width.empty())
    return 0;
  return 0.5 * (state.width[e] + state.width[e + 1 == state.width.size() ? 0 : e + 1]);
}

} // namespace linelet
