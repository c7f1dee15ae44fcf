// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/curves/em_fit.h>

#include <algorithm>
#include <cmath>

namespace linelet {

namespace {

// Pairs of a point and an edge count up to this many standard deviations.
constexpr double pair_reach = 3.5;
// The pairs are collected anew when the noise has shrunk to this share.
constexpr double stale_share = 0.6;

/** \brief Normal distribution function to 2e-4. */
double
normalBelow(double z)
{
  return 1 / (1 + std::exp(-z * (1.5976 + 0.07056 * z * z)));
}

} // namespace

void
EmFitter::collectPairs()
{
  reach_ = pair_reach * noise_;
  const double margin = 0.3 * noise_;
  const double reach = reach_ + margin;
  pair_point_.clear();
  for (Edge& edge : edges_) {
    edge.pairs_begin = pair_point_.size();
    const Point middle = edge.from + 0.5 * edge.length * edge.direction;
    grid_.forEachWithin(middle, reach + 0.5 * edge.length, [&](Index i, double) {
      const Point v = points_[i] - edge.from;
      const double z = v.dot(edge.direction);
      const double over = z - std::clamp(z, 0.0, edge.length);
      if (v.squaredNorm() - z * z + over * over <= reach * reach)
        pair_point_.push_back(i);
    });
    edge.pairs_end = pair_point_.size();
  }
  pair_density_.resize(pair_point_.size());
  pair_place_.resize(pair_point_.size());
  pair_off_.resize(pair_point_.size());
}

bool
EmFitter::pairsAreStale() const
{
  return pair_reach * noise_ < stale_share * reach_;
}

void
EmFitter::expect()
{
  const double background = outlier_share_ / frame_.volume;
  std::fill(density_.begin(), density_.end(), background);
  const double variance = noise_ * noise_;
  const double across = std::pow(2 * M_PI * variance, -0.5 * (frame_.dimensions - 1));
  for (const Edge& edge : edges_) {
    // The integral of the normal density along the edge: where the edge is short beside
    // the noise, a normal density of its own.
    const bool is_short = edge.length < 1.2 * noise_;
    const double along = variance + edge.length * edge.length / 12;
    const double factor =
        edge.weight * across *
        (is_short ? 1 / std::sqrt(2 * M_PI * along) : 1 / edge.length);
    for (std::size_t k = edge.pairs_begin; k < edge.pairs_end; ++k) {
      const Point v = points_[pair_point_[k]] - edge.from;
      const double z = v.dot(edge.direction);
      const double off = std::max(0.0, v.squaredNorm() - z * z);
      double density;
      if (is_short) {
        const double t = z - 0.5 * edge.length;
        density = factor * std::exp(-0.5 * (off / variance + t * t / along));
      }
      else
        density = factor * std::exp(-0.5 * off / variance) *
                  (normalBelow((edge.length - z) / noise_) - normalBelow(-z / noise_));
      pair_density_[k] = density;
      pair_place_[k] = z;
      pair_off_[k] = off;
      density_[pair_point_[k]] += density;
    }
  }

  log_likelihood_ = 0;
  double outliers = 0;
  for (double& density : density_) {
    density = std::max(density, 1e-300);
    log_likelihood_ += std::log(density);
    outliers += background / density;
  }
  edge_count_.assign(edges_.size(), 0);
  for (std::size_t e = 0; e < edges_.size(); ++e)
    for (std::size_t k = edges_[e].pairs_begin; k < edges_[e].pairs_end; ++k) {
      pair_density_[k] /= density_[pair_point_[k]];
      edge_count_[e] += pair_density_[k];
    }
  const auto n = static_cast<double>(points_.size());
  outlier_share_ = std::clamp(outliers / n, 1e-3, 1 - 1e-3);
}

} // namespace linelet
