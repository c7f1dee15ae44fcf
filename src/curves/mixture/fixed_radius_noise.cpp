// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>

#include "em_fit.h"
#include "fixed_radius_kernels.h"

namespace linelet {

namespace {

// What a point says at least.
constexpr double least_information = 0.05;
// The width of the sphere, as a share of its radius.
constexpr double widest = 0.3;

} // namespace

void
EmFitter::dropHollow(Edge& edge, double hollow)
{
  std::size_t kept = edge.pairs_begin;
  const Point to = edge.from + edge.length * edge.direction;
  for (std::size_t k = edge.pairs_begin; k < edge.pairs_end; ++k) {
    const Point x(pair_at_[0][k], pair_at_[1][k], pair_at_[2][k]);
    if (std::max((x - edge.from).squaredNorm(), (x - to).squaredNorm()) <
        hollow * hollow)
      continue;
    pair_index_[kept] = pair_index_[k];
    for (auto& coordinate : pair_at_)
      coordinate[kept] = coordinate[k];
    ++kept;
  }
  edge.pairs_end = kept;
}

FixedRadiusMeans
EmFitter::fixedRadiusMeansOf(const Edge& edge)
{
  const std::size_t begin = edge.pairs_begin;
  return {pair_place_.data() + begin,
          pair_residual_.data() + begin,
          pair_spread_.data() + begin};
}

void
EmFitter::fixedRadiusDensitiesOf(const Edge& edge)
{
  const double volume = 4 * M_PI * (fixed_radius_ * fixed_radius_ + noise_ * noise_);
  EdgeShape shape = shapeOf(edge);
  shape.factor = edge.weight / (edge.length * volume);
  fixedRadiusKernels().densities(shape,
                                 {fixed_radius_, noise_},
                                 pointsOf(edge),
                                 pair_density_.data() + edge.pairs_begin,
                                 fixedRadiusMeansOf(edge));
}

/** \brief Per point: what it says of its distance, relative to a point whose place on
 * the curve is known. */
void
EmFitter::measureInformation()
{
  const std::size_t n = points_.size();
  inlier_.assign(n, 0);
  residual_.assign(n, 0);
  information_.assign(n, 0);
  for (const Edge& edge : edges_)
    for (std::size_t k = edge.pairs_begin; k < edge.pairs_end; ++k) {
      const std::size_t i = pair_index_[k];
      inlier_[i] += pair_density_[k];
      residual_[i] += pair_density_[k] * pair_residual_[k];
      information_[i] += pair_density_[k] * pair_spread_[k];
    }
  for (std::size_t i = 0; i < n; ++i)
    if (inlier_[i] > 0) {
      const double mean = residual_[i] / inlier_[i];
      const double variance = information_[i] / inlier_[i] - mean * mean;
      information_[i] =
          std::clamp(1 - variance / (noise_ * noise_), least_information, 1.0);
    }
}

EdgeSums
EmFitter::fixedRadiusSumsOf(const Edge& edge, bool front, bool back)
{
  return fixedRadiusKernels().sums(shapeOf(edge),
                                   {fixed_radius_, noise_},
                                   pointsOf(edge),
                                   pair_density_.data() + edge.pairs_begin,
                                   fixedRadiusMeansOf(edge),
                                   pair_index_.data() + edge.pairs_begin,
                                   information_.data(),
                                   front,
                                   back);
}

void
EmFitter::measureFixedRadius(const EmSettings& settings)
{
  double sum = 0, square = 0, count = 0, information = 0;
  for (const Edge& edge : edges_)
    for (std::size_t k = edge.pairs_begin; k < edge.pairs_end; ++k)
      square += pair_density_[k] * pair_spread_[k];
  for (std::size_t i = 0; i < points_.size(); ++i) {
    sum += residual_[i];
    count += inlier_[i];
    information += inlier_[i] * information_[i];
  }
  if (!(count > 0))
    return;
  // A Newton step for the radius; a wider sphere is thinner.
  const double variance = noise_ * noise_;
  const double thinning =
      2 * variance * fixed_radius_ / (fixed_radius_ * fixed_radius_ + variance);
  const double shift = 0.5 * (sum - thinning * count) / information;
  fixed_radius_ =
      std::max(fixed_radius_ + std::clamp(shift, -0.3 * noise_, 0.3 * noise_),
               settings.least_noise);
  // Points inside the sphere say nothing of its width, so a longer step than that of
  // expectation maximization.
  const double change = std::pow(square / (variance * count), 1.5);
  noise_ =
      std::max(std::min(noise_ * std::clamp(change, 0.7, 1.4), widest * fixed_radius_),
               settings.least_noise);
}

double
EmFitter::kurtosis() const
{
  double count = 0, square = 0, fourth = 0;
  for (const Edge& edge : edges_)
    for (std::size_t k = edge.pairs_begin; k < edge.pairs_end; ++k) {
      const Point v = Point(pair_at_[0][k], pair_at_[1][k], pair_at_[2][k]) - edge.from;
      const double z = v.dot(edge.direction);
      const double off = std::max(0.0, v.squaredNorm() - z * z);
      count += pair_density_[k];
      square += pair_density_[k] * off;
      fourth += pair_density_[k] * off * off;
    }
  return square > 0 ? count * fourth / (square * square) : 0;
}

} // namespace linelet
