// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "e_step.h"

#include <algorithm>
#include <cmath>

namespace linelet {

namespace {

/** \brief The densities of \a edge at its points, with normal noise. */
void
densitiesOf(const MixtureState& mixture, const MixtureEdge& edge, EdgePairs& pairs)
{
  EdgeShape shape = shapeOf(edge);
  const double spread = 2 * M_PI * shape.variance;
  const double across =
      1 / (mixture.frame.dimensions == 3 ? spread : std::sqrt(spread));
  shape.factor =
      edge.weight * across *
      (shape.is_short
           ? 1 / std::sqrt(2 * M_PI * (shape.variance + edge.length * edge.length / 12))
           : 1 / edge.length);
  emKernels().densities(
      shape, pairs.pointsOf(edge), pairs.density.data() + edge.pairs_begin);
}

} // namespace

void
Expectation::operator()(MixtureState& mixture,
                        EdgePairs& pairs,
                        FixedRadiusNoise& fixed_radius)
{
  const double background = mixture.outlier_share / mixture.frame.volume;
  const std::size_t n = mixture.points;
  density_.assign(n + EdgePoints::padding, background);
  // A kernel writes past the end of its edge, where the next edge writes later.
  for (const MixtureEdge& edge : mixture.edges) {
    if (mixture.noise.fixed_radius > 0)
      FixedRadiusNoise::densities(mixture, edge, pairs);
    else
      densitiesOf(mixture, edge, pairs);
    for (std::size_t k = edge.pairs_begin; k < edge.pairs_end; ++k)
      density_[pairs.index[k]] += pairs.density[k];
  }

  mixture.log_likelihood = emKernels().invert(density_.data(), n);
  mixture.edge_count.resize(mixture.edges.size());
  double outliers = static_cast<double>(n);
  for (std::size_t e = 0; e < mixture.edges.size(); ++e) {
    const std::size_t begin = mixture.edges[e].pairs_begin;
    mixture.edge_count[e] = emKernels().share(density_.data(),
                                              pairs.index.data() + begin,
                                              pairs.density.data() + begin,
                                              mixture.edges[e].pairs_end - begin);
    outliers -= mixture.edge_count[e];
  }
  if (mixture.noise.fixed_radius > 0)
    fixed_radius.measureInformation(mixture, pairs);
  mixture.outlier_share = mixture.boundedShare(outliers / static_cast<double>(n));
}

} // namespace linelet
