// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "component_model.h"

#include <algorithm>

#include <boost/container_hash/hash.hpp>

#include "curves/mixture/model_score.h"
#include "curves/network/curve_similarity.h"
#include "curves/network/pairing.h"
#include "curves/ridges/spanning_curves.h"

namespace linelet {

namespace {

// A component at least this large is checked before the work: if hardly any
// neighborhood of sampled points is linear, it is a surface or a volume.
constexpr std::size_t large_component = 5000;
// A curve along the minimum spanning tree has at least this many edges. It runs through
// the points, so its fit begins with little noise; and as it follows the noise of thick
// clouds, it has to beat the ridges by this much.
constexpr std::size_t least_spanned = 6;
constexpr double spanning_bandwidth = 0.35;
constexpr double least_spanning_gain = 12;

/** \brief A hash of everything that a fit of \a start depends on. */
std::size_t
hashOf(const ModelCurves& start, const EmSettings& settings)
{
  std::size_t hash = 0;
  for (const ModelCurve& curve : start) {
    boost::hash_combine(hash, curve.closed);
    boost::hash_combine(hash, curve.junction);
    boost::hash_combine(hash, curve.hinges);
    for (const Point& node : curve.nodes)
      boost::hash_range(hash, node.data(), node.data() + 3);
  }
  boost::hash_combine(hash, settings.spacing);
  boost::hash_combine(hash, settings.noise);
  boost::hash_combine(hash, settings.fixed_radius);
  boost::hash_combine(hash, settings.varied_noise);
  boost::hash_combine(hash, settings.even_curvature);
  boost::hash_combine(hash, settings.scales);
  boost::hash_combine(hash, settings.iterations);
  return hash;
}

} // namespace

ComponentModel::ComponentModel(const Points& points,
                               double scale_unit,
                               const RefinedSettings& user,
                               const std::function<bool()>& stop)
    : points_(points),
      scale_unit_(scale_unit),
      frame_(frameOf(points, scale_unit)),
      grid_(points, 2 * scale_unit),
      fitter_(points, grid_, frame_, stop),
      user_(user)
{
  best_.score = scoreOfNothing(frame_, points.size());
}

double
ComponentModel::curveSize() const
{
  if (points_.size() <= large_component)
    return 1;
  for (const double size : {1.0, 2.5, 6.0, 15.0})
    if (looksLinear(points_, grid_, size * scale_unit_))
      return size;
  return 0;
}

EmFit
ComponentModel::fit(const ModelCurves& start, const EmSettings& settings, double rival)
{
  return fitter_.fit(start, settings, rival);
}

bool
ComponentModel::take(EmFit fit, const EmSettings& settings, double gain)
{
  const double score = scoreOf(fit, points_.size());
  if (fit.curves.empty() || !(score < best_.score - gain))
    return false;
  best_ = {std::move(fit), settings, score};
  return true;
}

bool
ComponentModel::improve(const ModelCurves& start,
                        const EmSettings& settings,
                        double gain)
{
  if (!tried_.insert(hashOf(start, settings)).second)
    return false;
  return take(fit(start, settings, best_.score), best_.settings, gain);
}

void
ComponentModel::vary(const ScaleField* scales, bool noise)
{
  scales_ = scales;
  varied_noise_ = noise;
}

double
ComponentModel::tryBandwidth(std::size_t k)
{
  const double b = bandwidths[k] * unit();
  std::optional<Traces>& traces = traces_[scales_ ? 1 : 0][k];
  if (!traces)
    traces = traceRidges(RidgeField(points_, b, scales_),
                         {user_.start_points, user_.max_iterations});
  return tryTraces(*traces, b);
}

void
ComponentModel::trySpanning()
{
  if (!spanning_)
    spanning_ = spanningCurves(points_, least_spanned);
  tryTraces(*spanning_, spanning_bandwidth * unit(), least_spanning_gain);
}

std::optional<Fitted>
ComponentModel::runnerUp(double most_behind) const
{
  const Fitted* result = nullptr;
  for (const Fitted& other : traced_)
    if (other.score < (result ? result->score : best_.score + most_behind) &&
        !ofOneCourse(other.fit.curves, best_.fit.curves, scale_unit_))
      result = &other;
  return result ? std::optional<Fitted>(*result) : std::nullopt;
}

double
ComponentModel::unit() const
{
  return scales_ ? scales_->unit() : scale_unit_;
}

double
ComponentModel::tryTraces(const Traces& traces, double b, double gain)
{
  const auto bandwidthAt = [&](const Point& x) {
    return scales_ ? b * scales_->at(x) : b;
  };
  double local = scales_ && !traces.meetings.empty() ? 0 : b; // where curves meet
  if (local == 0)
    for (const Point& meeting : traces.meetings)
      local += bandwidthAt(meeting) / static_cast<double>(traces.meetings.size());
  PairingSettings pairing;
  pairing.cluster = 2.5 * local;
  pairing.cut = 1.25 * local;
  pairing.reach = 3 * local;
  ModelCurves start = pairArms(traces.curves, traces.meetings, pairing);
  const bool alike =
      best_.settings.scales == scales_ && best_.settings.varied_noise == varied_noise_;
  if (start.empty() || (alike && ofOneCourse(start, best_.fit.curves, b)))
    return best_.score;
  for (ModelCurve& curve : start)
    curve.scale =
        std::min(bandwidthAt(curve.nodes.front()), bandwidthAt(curve.nodes.back()));
  EmSettings settings;
  settings.scales = scales_;
  settings.spacing = std::max(0.4 * unit(), 0.24 * b);
  settings.noise = 0.5 * b;
  settings.least_noise = 0.1 * unit();
  settings.bending = 1 / frame_.diagonal;
  settings.varied_noise = varied_noise_;
  settings.straight = user_.may_be_straight;
  settings.even_curvature = best_.settings.even_curvature;
  EmFit fit = fitter_.fit(start, settings, best_.score);
  const double score = scoreOf(fit, points_.size());
  if (!fit.curves.empty())
    traced_.push_back({fit, settings, score});
  take(std::move(fit), settings, gain);
  return score;
}

} // namespace linelet
