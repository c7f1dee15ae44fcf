// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fixed_radius_noise.h"

#include <algorithm>
#include <cmath>

#include "fixed_radius_kernels.h"

namespace linelet {

namespace {

// Lower bound of a point's information.
constexpr double least_information = 0.05;
// The width of the sphere, as a share of its radius.
constexpr double widest = 0.3;

FixedRadiusMeans
meansOf(const MixtureEdge& edge, EdgePairs& pairs)
{
  const std::size_t begin = edge.pairs_begin;
  return {pairs.place.data() + begin,
          pairs.residual.data() + begin,
          pairs.spread.data() + begin};
}

} // namespace

void
FixedRadiusNoise::densities(const MixtureState& mixture,
                            const MixtureEdge& edge,
                            EdgePairs& pairs)
{
  const double volume = 4 * M_PI *
                        (mixture.noise.fixed_radius * mixture.noise.fixed_radius +
                         mixture.noise.deviation * mixture.noise.deviation);
  EdgeShape shape = shapeOf(edge);
  shape.factor = edge.weight / (edge.length * volume);
  fixedRadiusKernels().densities(shape,
                                 {mixture.noise.fixed_radius, mixture.noise.deviation},
                                 pairs.pointsOf(edge),
                                 pairs.density.data() + edge.pairs_begin,
                                 meansOf(edge, pairs));
}

void
FixedRadiusNoise::measureInformation(const MixtureState& mixture,
                                     const EdgePairs& pairs)
{
  const std::size_t n = mixture.points;
  inlier_.assign(n, 0);
  residual_.assign(n, 0);
  information_.assign(n, 0);
  for (const MixtureEdge& edge : mixture.edges)
    for (std::size_t k = edge.pairs_begin; k < edge.pairs_end; ++k) {
      const std::size_t i = pairs.index[k];
      inlier_[i] += pairs.density[k];
      residual_[i] += pairs.density[k] * pairs.residual[k];
      information_[i] += pairs.density[k] * pairs.spread[k];
    }
  for (std::size_t i = 0; i < n; ++i)
    if (inlier_[i] > 0) {
      const double mean = residual_[i] / inlier_[i];
      const double variance = information_[i] / inlier_[i] - mean * mean;
      information_[i] =
          std::clamp(1 - variance / (mixture.noise.deviation * mixture.noise.deviation),
                     least_information,
                     1.0);
    }
}

EdgeSums
FixedRadiusNoise::sums(const MixtureState& mixture,
                       const MixtureEdge& edge,
                       EdgePairs& pairs,
                       bool front,
                       bool back) const
{
  return fixedRadiusKernels().sums(
      shapeOf(edge),
      {mixture.noise.fixed_radius, mixture.noise.deviation},
      pairs.pointsOf(edge),
      pairs.density.data() + edge.pairs_begin,
      meansOf(edge, pairs),
      pairs.index.data() + edge.pairs_begin,
      information_.data(),
      front,
      back);
}

void
FixedRadiusNoise::measure(MixtureState& mixture, const EdgePairs& pairs) const
{
  double sum = 0, square = 0, count = 0, information = 0;
  for (const MixtureEdge& edge : mixture.edges)
    for (std::size_t k = edge.pairs_begin; k < edge.pairs_end; ++k)
      square += pairs.density[k] * pairs.spread[k];
  for (std::size_t i = 0; i < mixture.points; ++i) {
    sum += residual_[i];
    count += inlier_[i];
    information += inlier_[i] * information_[i];
  }
  if (!(count > 0))
    return;
  // A Newton step for the radius; a wider sphere is thinner.
  const double variance = mixture.noise.deviation * mixture.noise.deviation;
  const double thinning =
      2 * variance * mixture.noise.fixed_radius /
      (mixture.noise.fixed_radius * mixture.noise.fixed_radius + variance);
  const double shift = 0.5 * (sum - thinning * count) / information;
  mixture.noise.fixed_radius =
      std::max(mixture.noise.fixed_radius + std::clamp(shift,
                                                       -0.3 * mixture.noise.deviation,
                                                       0.3 * mixture.noise.deviation),
               mixture.noise.least);
  // Points inside the sphere carry no information about its width, hence a longer step
  // than in expectation maximization.
  const double change = std::pow(square / (variance * count), 1.5);
  mixture.noise.deviation =
      std::max(std::min(mixture.noise.deviation * std::clamp(change, 0.7, 1.4),
                        widest * mixture.noise.fixed_radius),
               mixture.noise.least);
}

} // namespace linelet
