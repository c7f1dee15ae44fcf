// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "em_fit.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <linelet/support/progress_monitor.h>

#include "m_step.h"
#include "model_score.h"
#include "resampling.h"

namespace linelet {

namespace {

// A fit is abandoned if its score per point exceeds its rival's by more than this,
// divided by the iterations so far.
constexpr double most_behind = 5;

/** \brief The spacing of nodes: nodes much closer than the noise carry no
 * information. */
double
spacingOf(const MixtureState& mixture, const EmSettings& settings)
{
  double least = 0;
  for (const MixtureCurve& state : mixture.curves)
    for (const double width : state.width)
      least = std::min(least, width);
  return std::max(settings.spacing,
                  settings.least_spacing * mixture.noise.deviation * std::exp(least));
}

/** \brief Sums over the points of the curves, of powers of their distances from them.
 */
struct DistanceMoments {
  double count = 0, square = 0, fourth = 0;
};

DistanceMoments
distanceMoments(const MixtureState& mixture, const EdgePairs& pairs)
{
  DistanceMoments sums;
  for (const MixtureEdge& edge : mixture.edges)
    for (std::size_t k = edge.pairs_begin; k < edge.pairs_end; ++k) {
      const Point v = Point(pairs.at[0][k], pairs.at[1][k], pairs.at[2][k]) - edge.from;
      const double z = v.dot(edge.direction);
      const double off = std::max(0.0, v.squaredNorm() - z * z);
      sums.count += pairs.density[k];
      sums.square += pairs.density[k] * off;
      sums.fourth += pairs.density[k] * off * off;
    }
  return sums;
}

} // namespace

EmFitter::EmFitter(const Points& points,
                   const UniformGrid& grid,
                   const CloudFrame& frame,
                   std::function<bool()> stop)
    : grid_(grid), pairs_(grid), stop_(std::move(stop))
{
  mixture_.frame = frame;
  mixture_.points = points.size();
}

EmFit
EmFitter::fit(const ModelCurves& curves, const EmSettings& settings, double rival)
{
  mixture_.curves.clear();
  for (const ModelCurve& curve : curves)
    if (curve.edges() > 0) {
      mixture_.curves.emplace_back();
      mixture_.curves.back().curve = curve;
      mixture_.curves.back().bending = mixture_.curves.back().first_bending =
          settings.bending;
      if (settings.varied_noise)
        mixture_.curves.back().width.assign(curve.nodes.size(), 0);
    }
  mixture_.noise.least = settings.least_noise;
  mixture_.noise.varied = settings.varied_noise;
  mixture_.noise.deviation = std::max(settings.noise, settings.least_noise);
  mixture_.noise.fixed_radius = settings.fixed_radius;
  mixture_.most_outliers = settings.most_outliers;
  mixture_.outlier_share = mixture_.boundedShare(settings.outlier_share);
  mixture_.freedom = 0;
  mixture_.edge_count.clear();
  resampleCurves(settings);
  for (int i = 0; i < settings.iterations; ++i) {
    if (stop_ && stop_())
      throw Canceled();
    if (i > 0 && i % settings.resample_every == 0) {
      expect();
      if (trailsBehind(rival, i))
        return result();
      free_ends_.prune(mixture_, pairs_);
      FreeEnds::extend(mixture_, spacingOf(mixture_, settings), settings.scales);
      resampleCurves(settings);
    }
    else if (pairs_.areStale(mixture_))
      pairs_.collect(mixture_);
    expect();
    const bool settled = i > 0 && i % settings.resample_every == 0;
    maximize(mixture_,
             pairs_,
             fixed_radius_,
             system_,
             settings,
             settings.straight && settled);
  }
  expect();
  if (free_ends_.prune(mixture_, pairs_)) {
    resampleCurves(settings);
    for (int i = 0; i < 2; ++i) {
      expect();
      maximize(mixture_, pairs_, fixed_radius_, system_, settings);
    }
    expect();
  }

  return result();
}

bool
EmFitter::trailsBehind(double rival, int iterations) const
{
  const double lead = most_behind * static_cast<double>(mixture_.points) / iterations;
  return rival < std::numeric_limits<double>::infinity() &&
         scoreOf(scored(), mixture_.points) > rival + lead;
}

EmFit
EmFitter::scored() const
{
  EmFit fit;
  fit.log_likelihood = mixture_.log_likelihood;
  fit.freedom = mixture_.freedom;
  fit.width_cost = mixture_.noise.width_cost;
  fit.outlier_share = mixture_.outlier_share;
  for (const MixtureCurve& state : mixture_.curves)
    fit.curves.push_back(state.curve);
  return fit;
}

EmFit
EmFitter::result() const
{
  EmFit fit = scored();
  fit.noise = mixture_.noise.deviation;
  fit.fixed_radius = mixture_.noise.fixed_radius;
  const DistanceMoments sums = distanceMoments(mixture_, pairs_);
  if (sums.square > 0) {
    fit.kurtosis = sums.count * sums.fourth / (sums.square * sums.square);
    fit.spread =
        std::sqrt(sums.square / (sums.count * (mixture_.frame.dimensions - 1)));
  }
  const double background = mixture_.outlier_share / mixture_.frame.volume;
  fit.outlier.resize(mixture_.points);
  for (std::size_t sorted_index = 0; sorted_index < grid_.size(); ++sorted_index)
    fit.outlier[grid_.inputIndices()[sorted_index]] =
        background * expectation_.inverseDensities()[sorted_index];
  for (const MixtureCurve& state : mixture_.curves) {
    fit.noises.emplace_back();
    for (const double width : state.width)
      fit.noises.back().push_back(mixture_.noise.deviation * std::exp(width));
    const auto begin =
        mixture_.edge_count.begin() + static_cast<std::ptrdiff_t>(state.first_edge);
    fit.counts.emplace_back(begin,
                            begin + static_cast<std::ptrdiff_t>(state.curve.edges()));
  }
  return fit;
}

void
EmFitter::resampleCurves(const EmSettings& settings)
{
  resample(mixture_, spacingOf(mixture_, settings), settings.scales);
  pairs_.collect(mixture_);
}

} // namespace linelet
