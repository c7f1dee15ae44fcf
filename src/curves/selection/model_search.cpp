// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "model_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <linelet/search/scale_unit.h>

#include "curves/network/bridging.h"
#include "curves/network/corners.h"
#include "curves/network/curve_similarity.h"
#include "curves/network/doubling.h"
#include "curves/network/revision.h"
#include "curves/network/simpler_networks.h"
#include "curves/ridges/connected_components.h"
#include "curves/ridges/ridge_trace.h"
#include "curves/ridges/straight_segments.h"

namespace linelet {

namespace {

constexpr int most_rounds = 3;
constexpr int most_rejoinings = 2;
constexpr int most_simplifications = 8;
// Curves may be joined wrongly where they pass within this many standard deviations, or
// D.
constexpr double doubt_noise = 2;
constexpr double doubt_unit = 0.6;
// Up to this many places are rejoined one by one, more of them all at once.
constexpr std::size_t most_single_places = 8;
constexpr double least_gain = 1; // of the score, for another topology to be accepted
// Bends within this many standard deviations, or D, may be corners.
constexpr std::array<double, 2> bend_noise = {1, 2};
constexpr double bend_unit = 0.5;
constexpr int near_iterations = 8; // if the start is close
// A curve is doubled if the variance of its points in one direction is this many times
// that in the other; fixed-radius noise gives a smaller ratio for the same distance of
// a pair.
constexpr double doubled_spread = 2;
constexpr double doubled_fixed_radius_spread = 1.3;
// Fixed-radius noise is tried if the noise exceeds its lower bound by this factor, with
// a width of this share of its radius.
constexpr double least_fixed_radius = 1.2;
constexpr double fixed_radius_width = 0.2;
constexpr int fixed_radius_iterations = 10; // the start is near
// Varying noise is tried if the kurtosis is at least this share of that of normal
// noise: the points farthest out count as outliers and are missing from it.
constexpr double least_tails = 0.9;
// Effective parameters per curve, across it, above which even curvature is tried: an
// arc has three.
constexpr double least_even_curvature = 6;
constexpr double pair_share = 0.7;    // of the noise of the single curve, initially
constexpr double most_kurtosis = 2.2; // 2 for normal noise
constexpr std::size_t least_rest = 8;
// Segments stand out from at least this share of the points, spread evenly. Their least
// length in standard deviations and in D, and the distance at which their ends meet.
constexpr double least_background = 0.02;
constexpr double segment_noises = 4, segment_units = 2;
constexpr double meeting_noises = 4, meeting_units = 1;

/** \brief The kurtosis of normal noise (\ref EmFit): fourth moment over squared second
 * moment of the distance from a line. */
double
normalKurtosis(int dimensions)
{
  return dimensions == 3 ? 2 : 3;
}

/** \brief The doubtful places of \a curves (\ref doubtfulPlaces), grouped by what is
 * rejoined together. */
std::vector<Points>
placesToRejoin(const ModelCurves& curves, double size)
{
  const Points places = doubtfulPlaces(curves, size);
  std::vector<Points> result;
  for (const Indices& group : connectedComponents(places, size, 1)) {
    result.emplace_back();
    for (const Index i : group)
      result.back().push_back(places[i]);
  }
  return result.size() > most_single_places ? std::vector<Points>{places} : result;
}

/** \brief Rejoins every doubtful place once.
 * \return whether anything was better */
bool
rejoinOnce(ComponentModel& component)
{
  const EmFit& best = component.best().fit;
  bool better = false;
  for (const double factor : {1.0, 2.0}) {
    const double size =
        factor * std::max(doubt_noise * best.noise, doubt_unit * component.scaleUnit());
    for (const Points& places : placesToRejoin(best.curves, size))
      for (const Rejoining rejoining : {Rejoining::Paired, Rejoining::Bridged}) {
        const ModelCurves start = rejoined(best.curves, places, size, rejoining);
        if (ofOneCourse(start, best.curves, size))
          continue;
        EmSettings settings = component.best().settings;
        settings.noise = best.noise;
        better = component.improve(start, settings, least_gain) || better;
      }
  }
  return better;
}

/** \brief The place on \a curve nearest to \a p. */
Point
nearestOn(const ModelCurve& curve, const Point& p)
{
  Point nearest = curve.nodes.front();
  for (std::size_t e = 0; e < curve.edges(); ++e) {
    const Point way = curve.to(e) - curve.from(e);
    const double t = way.dot(p - curve.from(e)) / std::max(way.squaredNorm(), 1e-300);
    const Point place = curve.from(e) + std::clamp(t, 0.0, 1.0) * way;
    if ((place - p).squaredNorm() < (nearest - p).squaredNorm())
      nearest = place;
  }
  return nearest;
}

/** \brief \a curves with their free ends led to the nearest other curve within
 * \a reach. */
ModelCurves
attached(const ModelCurves& curves, double reach)
{
  ModelCurves result = curves;
  for (std::size_t c = 0; c < curves.size(); ++c)
    for (std::size_t end = 0; end < 2 && !curves[c].closed; ++end) {
      Point& tip = end == 0 ? result[c].nodes.front() : result[c].nodes.back();
      const Point from = tip;
      double nearest = reach;
      for (std::size_t other = 0; other < curves.size(); ++other) {
        const Point place = nearestOn(curves[other], from);
        if (other == c || (place - from).norm() > nearest)
          continue;
        nearest = (place - from).norm();
        tip = place;
        result[c].junction[end] = 0;
      }
    }
  return result;
}

/** \brief \a fitted with every curve doubled whose points lie on two sides of it,
 * fitted again; no curves if there are none to double. A fit that falls far behind the
 * score \a rival is abandoned. */
EmFit
doubledFit(ComponentModel& component, const Fitted& fitted, double rival)
{
  const double noise = fitted.fit.noise;
  const ModelCurves pairs = doubled(fitted.fit.curves,
                                    component.points(),
                                    component.grid(),
                                    4 * noise,
                                    doubled_spread);
  if (pairs.empty())
    return {};
  EmSettings settings = fitted.settings;
  settings.noise = 0.6 * noise;
  return component.fit(pairs, settings, rival);
}

} // namespace

EmFit
doubleCurves(ComponentModel& component)
{
  const EmSettings settings = component.best().settings;
  // In 3D, fixed-radius noise may still improve it.
  const double rival = component.dimensions() == 3
                           ? std::numeric_limits<double>::infinity()
                           : component.best().score;
  EmFit fit = doubledFit(component, component.best(), rival);
  const bool taken = component.take(fit, settings);
  // One curve between two explains their points worse than a narrower bandwidth that
  // leaves both in pieces; yet doubled it becomes both of them.
  ModelCurves last;
  for (const Fitted& other : component.traced()) {
    const ModelCurves& curves = other.fit.curves;
    if (curves.size() >= component.best().fit.curves.size() ||
        ofOneCourse(curves, last, other.fit.noise))
      continue;
    component.take(doubledFit(component, other, component.best().score),
                   other.settings);
    last = curves;
  }
  return taken ? EmFit{} : fit;
}

void
rejoin(ComponentModel& component)
{
  // Rejoining one place may reveal what is wrong in another.
  for (int round = 0; round < most_rejoinings && rejoinOnce(component); ++round) {
  }
}

void
traceTheRest(ComponentModel& component, double widest_unit)
{
  const Points& points = component.points();
  const EmFit& best = component.best().fit;
  for (int round = 0; round < most_rounds && !best.curves.empty(); ++round) {
    Points rest;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (best.outlier[i] > 0.5)
        rest.push_back(points[i]);
    if (rest.size() < least_rest)
      break;
    const double unit = scaleUnit(rest, 1024, 1, 1);
    if (!(unit > 0) || unit > widest_unit)
      break;
    Traces traces = traceRidges(RidgeField(rest, unit), {});
    if (traces.curves.empty())
      break;
    for (ModelCurve& curve : traces.curves)
      curve.scale = unit;
    ModelCurves start = best.curves;
    start.insert(start.end(), traces.curves.begin(), traces.curves.end());
    EmSettings settings = component.best().settings;
    settings.noise = std::max(best.noise, 0.25 * unit);
    if (!component.take(component.fit(start, settings), component.best().settings))
      break;
  }
}

void
followNoise(ComponentModel& component, const ScaleField* scales)
{
  const EmFit& best = component.best().fit;
  if (best.curves.empty() ||
      best.kurtosis <= least_tails * normalKurtosis(component.dimensions()))
    return;
  EmSettings settings = component.best().settings;
  settings.varied_noise = true;
  settings.noise = best.noise;
  if (!component.take(component.fit(best.curves, settings), settings))
    return;
  component.vary(nullptr, true);
  for (std::size_t k = 0; k < bandwidths.size(); ++k)
    component.tryBandwidth(k);
  if (!scales)
    return;
  component.vary(scales, true);
  for (const std::size_t k : varied_bandwidths)
    component.tryBandwidth(k);
}

void
simplify(ComponentModel& component)
{
  bool better = true;
  for (int round = 0; round < most_simplifications && better; ++round) {
    const EmFit best = component.best().fit;
    EmSettings settings = component.best().settings;
    if (!settings.varied_noise && !settings.scales)
      return;
    settings.noise = best.noise;
    better = false;
    for (const ModelCurves& start :
         simplerNetworks(best.curves, component.scaleUnit(), settings.scales)) {
      if (component.improve(start, settings, least_gain))
        better = true;
    }
  }
}

void
fitFixedRadius(ComponentModel& component, const EmFit& other)
{
  const EmSettings settings = component.best().settings;
  if (component.best().fit.curves.empty() || settings.scales ||
      component.dimensions() < 3)
    return;
  const EmFit normal = component.best().fit;
  for (const EmFit* start : {&normal, &other}) {
    if (start->curves.empty() ||
        start->noise < least_fixed_radius * settings.least_noise ||
        start->kurtosis > most_kurtosis)
      continue;
    EmSettings trial = settings;
    trial.fixed_radius = std::sqrt(3.0) * start->noise;
    trial.noise = fixed_radius_width * trial.fixed_radius;
    trial.iterations = fixed_radius_iterations;
    component.take(component.fit(start->curves, trial, component.best().score), trial);
  }
  // Normal noise hides curves whose points lie at a distance rather than around them.
  const EmFit& best = component.best().fit;
  const double noise = best.deviation();
  const ModelCurves pairs = doubled(best.curves,
                                    component.points(),
                                    component.grid(),
                                    4 * noise,
                                    doubled_fixed_radius_spread);
  if (pairs.empty())
    return;
  EmSettings trial = settings;
  trial.fixed_radius = pair_share * std::sqrt(3.0) * noise;
  trial.noise = fixed_radius_width * trial.fixed_radius;
  trial.iterations = fixed_radius_iterations;
  component.take(component.fit(pairs, trial, component.best().score), trial);
}

void
evenCurvature(ComponentModel& component)
{
  const EmFit& best = component.best().fit;
  EmSettings settings = component.best().settings;
  const double curves = static_cast<double>(best.curves.size());
  // Without noise the points fully determine the shape.
  if (best.noise <= settings.least_noise ||
      best.freedom <= least_even_curvature * (component.dimensions() - 1) * curves)
    return;
  settings.even_curvature = true;
  settings.noise = best.noise;
  component.take(component.fit(best.curves, settings), settings, least_gain);
}

bool
trySegments(ComponentModel& component)
{
  const EmFit& best = component.best().fit;
  if (best.curves.size() < 2)
    return false;
  const double n = static_cast<double>(component.points().size());
  const double noise = best.deviation(), unit = component.scaleUnit();
  SegmentSettings search;
  search.noise = noise;
  search.density = n * (1 - best.outlier_share) / length(best.curves);
  search.background =
      n * std::max(best.outlier_share, least_background) / component.frame().volume;
  search.dimensions = component.dimensions();
  search.least_length = std::max(segment_noises * noise, segment_units * unit);
  ModelCurves segments = straightSegments(component.points(), search);
  if (segments.empty())
    return false;
  const double meeting = std::max(meeting_noises * noise, meeting_units * unit);
  for (ModelCurve& segment : segments)
    segment.scale = 0.5 * meeting;
  EmSettings settings = component.best().settings;
  settings.noise = best.noise;
  settings.fixed_radius = best.fixed_radius;
  settings.iterations = EmSettings().iterations;
  bool better = component.improve(segments, settings, 0);
  const ModelCurves joined = bridgeGaps(segments, meeting, 0, meeting, M_PI);
  better = component.improve(joined, settings, 0) || better;
  if (better)
    component.improve(attached(best.curves, meeting), settings, 0);
  return better;
}

void
sharpen(ComponentModel& component)
{
  const EmFit& best = component.best().fit;
  for (const double factor : bend_noise) {
    const double size =
        factor * std::max(best.deviation(), bend_unit * component.scaleUnit());
    const ModelCurves start = sharpened(best.curves, size);
    if (start.empty())
      continue;
    EmSettings settings = component.best().settings;
    settings.noise = best.noise;
    settings.fixed_radius = best.fixed_radius;
    settings.iterations = near_iterations;
    component.improve(start, settings, least_gain);
  }
}

} // namespace linelet
