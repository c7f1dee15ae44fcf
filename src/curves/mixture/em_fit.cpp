// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "em_fit.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <linelet/support/progress_monitor.h>

#include "curves/ridges/sorted_kernels.h"
#include "curves/selection/model_score.h"

namespace linelet {

namespace {

constexpr double first_outlier_share = 0.1;
constexpr double least_points = 2;
// A fit is given up whose score per point is above that of its rival by more than this,
// divided by the iterations so far.
constexpr double most_behind = 5;

/** \brief Values at equal steps along a curve, at \a count equal steps. */
std::vector<double>
stretched(const std::vector<double>& values, std::size_t count, bool closed)
{
  const std::size_t n = values.size();
  const double step = static_cast<double>(closed ? n : n - 1) /
                      static_cast<double>(closed ? count : count - 1);
  std::vector<double> result;
  for (std::size_t k = 0; k < count; ++k) {
    const double place = step * static_cast<double>(k);
    const auto i = std::min(static_cast<std::size_t>(place), n - 1);
    const double t = place - static_cast<double>(i);
    const std::size_t next = i + 1 < n ? i + 1 : closed ? 0 : n - 1;
    result.push_back((1 - t) * values[i] + t * values[next]);
  }
  return result;
}

} // namespace

EmFitter::EmFitter(const Points& points,
                   const UniformGrid& grid,
                   const CloudFrame& frame,
                   std::function<bool()> stop)
    : points_(points),
      grid_(grid),
      sorted_(std::make_shared<SortedArrays>(grid)),
      frame_(frame),
      stop_(std::move(stop))
{
}

EmFit
EmFitter::fit(const ModelCurves& curves, const EmSettings& settings, double rival)
{
  states_.clear();
  for (const ModelCurve& curve : curves)
    if (curve.edges() > 0) {
      states_.emplace_back();
      states_.back().curve = curve;
      states_.back().bending = states_.back().first_bending = settings.bending;
      if (settings.varied_noise)
        states_.back().width.assign(curve.nodes.size(), 0);
    }
  least_noise_ = settings.least_noise;
  varied_ = settings.varied_noise;
  noise_ = std::max(settings.noise, settings.least_noise);
  fixed_radius_ = settings.fixed_radius;
  outlier_share_ = first_outlier_share;
  freedom_ = 0;
  edge_count_.clear();
  // Nodes much closer than the noise say nothing.
  const auto spacing = [&] {
    double least = 0;
    for (const CurveState& state : states_)
      for (const double width : state.width)
        least = std::min(least, width);
    return std::max(settings.spacing,
                    settings.least_spacing * noise_ * std::exp(least));
  };
  resampleCurves(spacing(), settings.scales);
  for (int i = 0; i < settings.iterations; ++i) {
    if (stop_ && stop_())
      throw Canceled();
    if (i > 0 && i % settings.resample_every == 0) {
      expect();
      if (trailsBehind(rival, i))
        return result();
      prune();
      extendEnds(spacing(), settings.scales);
      resampleCurves(spacing(), settings.scales);
    }
    else if (pairsAreStale())
      collectPairs();
    expect();
    maximize(settings);
  }
  expect();
  if (prune()) {
    resampleCurves(spacing(), settings.scales);
    for (int i = 0; i < 2; ++i) {
      expect();
      maximize(settings);
    }
    expect();
  }

  return result();
}

bool
EmFitter::trailsBehind(double rival, int iterations) const
{
  const double lead = most_behind * static_cast<double>(points_.size()) / iterations;
  return rival < std::numeric_limits<double>::infinity() &&
         scoreOf(scored(), points_.size()) > rival + lead;
}

EmFit
EmFitter::scored() const
{
  EmFit fit;
  fit.log_likelihood = log_likelihood_;
  fit.freedom = freedom_;
  fit.width_cost = width_cost_;
  fit.outlier_share = outlier_share_;
  for (const CurveState& state : states_)
    fit.curves.push_back(state.curve);
  return fit;
}

EmFit
EmFitter::result() const
{
  EmFit fit = scored();
  fit.noise = noise_;
  fit.fixed_radius = fixed_radius_;
  fit.kurtosis = kurtosis();
  const double background = outlier_share_ / frame_.volume;
  fit.outlier.resize(points_.size());
  for (std::size_t sorted_index = 0; sorted_index < grid_.size(); ++sorted_index)
    fit.outlier[grid_.inputIndices()[sorted_index]] =
        background * density_[sorted_index];
  for (const CurveState& state : states_) {
    fit.noises.emplace_back();
    for (const double width : state.width)
      fit.noises.back().push_back(noise_ * std::exp(width));
    const auto begin =
        edge_count_.begin() + static_cast<std::ptrdiff_t>(state.first_edge);
    fit.counts.emplace_back(begin,
                            begin + static_cast<std::ptrdiff_t>(state.curve.edges()));
  }
  return fit;
}

void
EmFitter::resampleCurves(double spacing, const ScaleField* scales)
{
  // Each curve keeps its share of the mixture, spread evenly over its new edges.
  std::vector<double> share(states_.size());
  double total = 0;
  std::size_t kept = 0;
  for (std::size_t c = 0; c < states_.size(); ++c) {
    if (edge_count_.empty())
      share[c] = length(states_[c].curve);
    else
      for (std::size_t e = 0; e < states_[c].curve.edges(); ++e)
        share[c] += edge_count_[states_[c].first_edge + e];
    // What has lost its points or its length is no curve any more.
    const bool lost = !edge_count_.empty() && share[c] < least_points;
    const double narrow = scales ? scales->at(states_[c].curve.nodes.front()) : 1;
    if (lost || length(states_[c].curve) < spacing * std::min(1.0, narrow))
      continue;
    total += share[c];
    if (kept != c) {
      states_[kept] = std::move(states_[c]);
      share[kept] = share[c];
    }
    ++kept;
  }
  states_.resize(kept);
  edges_.clear();
  for (std::size_t c = 0; c < states_.size(); ++c) {
    CurveState& state = states_[c];
    const double least_edges = state.curve.closed ? 8 : 2;
    if (scales)
      state.curve = resampled(state.curve, spacing, *scales, least_edges);
    else
      state.curve =
          resampled(state.curve, std::min(spacing, length(state.curve) / least_edges));
    if (!state.width.empty())
      state.width =
          stretched(state.width, state.curve.nodes.size(), state.curve.closed);
    state.first_edge = edges_.size();
    state.bend_variance.clear();
    state.bend_weight.clear();
    Edge edge;
    edge.weight = (1 - outlier_share_) * share[c] /
                  (std::max(total, 1e-300) * static_cast<double>(state.curve.edges()));
    edges_.insert(edges_.end(), state.curve.edges(), edge);
    if (scales)
      for (std::size_t e = 0; e < state.curve.edges(); ++e)
        edges_[state.first_edge + e].scale =
            scales->at(0.5 * (state.curve.from(e) + state.curve.to(e)));
  }
  updateEdges();
  collectPairs();
}

double
EmFitter::scaledLength(const CurveState& state) const
{
  double sum = 0;
  for (std::size_t e = 0; e < state.curve.edges(); ++e)
    sum += edges_[state.first_edge + e].length / edges_[state.first_edge + e].scale;
  return sum;
}

void
EmFitter::updateEdges()
{
  for (const CurveState& state : states_)
    for (std::size_t e = 0; e < state.curve.edges(); ++e) {
      Edge& edge = edges_[state.first_edge + e];
      edge.from = state.curve.from(e);
      const Point chord = state.curve.to(e) - edge.from;
      edge.length = std::max(chord.norm(), 1e-12 * frame_.diagonal);
      edge.direction = chord / edge.length;
      const double noise =
          state.width.empty() ? noise_ : noise_ * std::exp(widthAt(state, e));
      edge.noise = std::max(noise, least_noise_) * edge.scale;
    }
}

} // namespace linelet
