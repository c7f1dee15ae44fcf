// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "refine_component.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include <linelet/search/scale_unit.h>

#include "model_search.h"
#include "thinned_component.h"

namespace linelet {

namespace {

// If a bandwidth scores this much worse than the best so far, those beyond it are not
// tried.
constexpr double hopeless_score = 60;
// The bandwidth of a component at least this large is chosen on a few samples of
// neighboring points.
constexpr std::size_t sampled_component = 60000;
constexpr std::size_t sample_size = 8000;
constexpr std::size_t samples = 3;
// In such a component, unexplained points with a scale unit above this, in D, are left
// alone: their fit would begin with noise so wide that every point is near every curve.
constexpr double widest_rest = 15;
// In components up to this size, two fits are revised: also the second best, if its
// score is behind by no more than this.
constexpr std::size_t revised_component = 5000;
constexpr double most_behind = 50;
// In components up to this size, networks with fewer ends or curves are tried.
constexpr std::size_t simplified_component = 5000;
// With fewer points than this, ridges may fail however even the spacing.
constexpr std::size_t spanned_component = 200;

/** \brief The number of the bandwidth that fits best around a few points. */
std::size_t
bandwidthOfSamples(const Points& points,
                   const UniformGrid& grid,
                   const RefinedSettings& user,
                   const std::function<bool()>& stop)
{
  std::array<double, bandwidths.size()> scores{};
  for (std::size_t s = 0; s < samples; ++s) {
    const Point& middle = points[(2 * s + 1) * points.size() / (2 * samples)];
    Points sample;
    for (const Index i : grid.nearestK(middle, sample_size))
      sample.push_back(points[i]);
    const double unit = scaleUnit(sample, 1024, 1, 1);
    for (std::size_t k = 0; unit > 0 && k < bandwidths.size(); ++k) {
      // Each on its own, so that each gets its own score.
      ComponentModel component(sample, unit, user, stop);
      component.tryBandwidth(k);
      scores[k] += component.best().score;
    }
  }
  return static_cast<std::size_t>(std::min_element(scores.begin(), scores.end()) -
                                  scores.begin());
}

/** \brief Tries the bandwidths one after the other. */
void
tryBandwidths(ComponentModel& component, const std::function<void(double)>& progress)
{
  bool hopeless = false;
  for (std::size_t k = 0; k < bandwidths.size(); ++k) {
    if (k == first_upwards)
      hopeless = false;
    if (!hopeless) {
      const double score = component.tryBandwidth(k);
      hopeless = score > component.best().score + hopeless_score;
    }
    progress(static_cast<double>(k + 1) / (2.0 + bandwidths.size()));
  }
}

/** \brief Tries other topologies for the best fit.
 * \return the fit that \ref doubleCurves rejected */
EmFit
revise(ComponentModel& component, const ScaleField* scales)
{
  const std::size_t size = component.points().size();
  const bool sampled = size > sampled_component;
  if (size <= simplified_component)
    simplify(component);
  EmFit rejected = doubleCurves(component);
  rejoin(component);
  if (size <= (scales ? simplified_component : spanned_component))
    component.trySpanning();
  constexpr double any = std::numeric_limits<double>::infinity();
  traceTheRest(component, sampled ? widest_rest * component.scaleUnit() : any);
  if (size <= simplified_component)
    simplify(component);
  return rejected;
}

/** \brief Tries fixed-radius noise and corners for the best fit. */
void
finish(ComponentModel& component, const EmFit& rejected)
{
  fitFixedRadius(component, rejected);
  sharpen(component);
}

/** \brief Revises the runner-up of the bandwidths as well as the best fit, since it
 * often wins in the end. */
void
reviseBoth(ComponentModel& component, const ScaleField* scales, bool may_be_straight)
{
  const std::optional<Fitted> runner_up = component.runnerUp(most_behind);
  finish(component, revise(component, scales));
  if (runner_up) {
    const Fitted best = component.best();
    component.goOnFrom(*runner_up);
    finish(component, revise(component, scales));
    if (best.score <= component.best().score)
      component.goOnFrom(best);
  }
  if (may_be_straight && trySegments(component))
    finish(component, revise(component, scales));
}

/** \brief Fits a share of \a points whose curves are thick compared with their spacing;
 * the counts are scaled to all points. */
EmFit
refineThinned(const Points& points,
              double size,
              const RefinedSettings& user,
              const std::function<bool()>& stop,
              const std::function<void(double)>& progress)
{
  const ThinnedComponent some = thinnedComponent(points, size);
  EmFit fit = refineComponent(some.points, user, nullptr, stop, progress);
  for (auto& counts : fit.counts)
    for (double& count : counts)
      count /= some.share;
  return fit;
}

} // namespace

EmFit
refineComponent(const Points& points,
                const RefinedSettings& user,
                const ScaleField* scales,
                const std::function<bool()>& stop,
                const std::function<void(double)>& progress)
{
  const double scale_unit =
      points.size() < least_component ? 0 : scaleUnit(points, 1024, 1, 1);
  if (!(scale_unit > 0))
    return {};
  ComponentModel component(points, scale_unit, user, stop);
  const double size = component.curveSize();
  if (size > 1)
    return refineThinned(points, size, user, stop, progress);
  if (size == 0)
    return {};

  // Many fits, or an integral for every pair, are too slow for millions of points.
  const bool sampled = points.size() > sampled_component;
  if (sampled) {
    const std::size_t chosen = bandwidthOfSamples(points, component.grid(), user, stop);
    progress(0.4);
    component.tryBandwidth(chosen);
  }
  else {
    tryBandwidths(component, progress);
    if (scales) {
      component.vary(scales, false);
      for (const std::size_t k : varied_bandwidths)
        component.tryBandwidth(k);
    }
    evenCurvature(component);
    followNoise(component, scales);
  }
  if (points.size() <= revised_component)
    reviseBoth(component, scales, user.may_be_straight);
  else {
    const EmFit rejected = revise(component, scales);
    if (!sampled)
      finish(component, rejected);
  }
  return component.release();
}

} // namespace linelet
