// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "part_moves.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <linelet/search/scale_unit.h>

#include "corners.h"
#include "curve_doubling.h"
#include "curve_likeness.h"
#include "junction_revision.h"
#include "refined_part.h"
#include "ridge_trace.h"
#include "simpler_networks.h"

namespace linelet {

namespace {

constexpr int most_rounds = 3;
constexpr int most_rejoinings = 2;
constexpr int most_simplifications = 8;
// Curves may be joined wrongly where they pass within so many standard deviations, or
// D.
constexpr double doubt_noise = 2;
constexpr double doubt_unit = 0.6;
// Up to so many places are rejoined each by itself, more of them all at once.
constexpr std::size_t most_single_places = 8;
constexpr double least_gain = 1; // of the score, by which another topology is better
// Bends within so many standard deviations, or D, may be corners.
constexpr std::array<double, 2> bend_noise = {1, 2};
constexpr double bend_unit = 0.5;
constexpr int near_iterations = 8; // where the start is near
// A curve is doubled where the variance of its points one way is this many times that
// the other way; for noise of one length it is smaller beside the distance of a pair.
constexpr double doubled_spread = 2;
constexpr double doubled_shell_spread = 1.3;
// Noise of one length is tried where the noise is that much wider than the least, with
// a width of this share of its length. The peakedness is 2 for normal noise.
constexpr double least_shell = 1.2;
constexpr double shell_width = 0.2;
constexpr int shell_iterations = 10; // the start is near
// Noise that varies is tried where the peakedness is at least this share of that of
// normal noise: what lies farthest out is taken for outliers, and missing in it.
constexpr double least_tails = 0.9;
// The curves' effective parameters across them, per curve, from which on they may be
// thought to bend evenly: an arc has three.
constexpr double least_arched = 6;
constexpr double pair_share = 0.7; // of the noise of one curve, to begin with
constexpr double most_peakedness = 2.2;
constexpr std::size_t least_rest = 8;

/** \brief The peakedness of normal noise (\ref EmFit): fourth moment over squared
 * second of the distance from a line. */
double
normalPeakedness(int dimensions)
{
  return dimensions == 3 ? 2 : 3;
}

/** \brief The doubtful places of \a curves (\ref doubtfulPlaces) in groups that are
 * rejoined together. */
std::vector<Points>
placesToRejoin(const ModelCurves& curves, double size)
{
  const Points places = doubtfulPlaces(curves, size);
  std::vector<Points> result;
  for (const Indices& group : connectedParts(places, size, 1)) {
    result.emplace_back();
    for (const Index i : group)
      result.back().push_back(places[i]);
  }
  return result.size() > most_single_places ? std::vector<Points>{places} : result;
}

/** \brief Rejoins every doubtful place once.
 * \return whether anything was better */
bool
rejoinOnce(PartInWork& part)
{
  const EmFit& best = part.best().fit;
  bool better = false;
  for (const double factor : {1.0, 2.0}) {
    const double size =
        factor * std::max(doubt_noise * best.noise, doubt_unit * part.scaleUnit());
    for (const Points& places : placesToRejoin(best.curves, size))
      for (const Rejoining rejoining : {Rejoining::Paired, Rejoining::Bridged}) {
        const ModelCurves start = rejoined(best.curves, places, size, rejoining);
        if (ofOneCourse(start, best.curves, size))
          continue;
        EmSettings settings = part.best().settings;
        settings.noise = best.noise;
        better = part.improve(start, settings, least_gain) || better;
      }
  }
  return better;
}

/** \brief The fit that \a fitted becomes when every curve is doubled whose points lie
 * to two sides of it; no curve where there is none. What falls far behind the score
 * \a rival is given up. */
EmFit
doubledFit(PartInWork& part, const Fitted& fitted, double rival)
{
  const double noise = fitted.fit.noise;
  const ModelCurves pairs =
      doubled(fitted.fit.curves, part.points(), part.grid(), 4 * noise, doubled_spread);
  if (pairs.empty())
    return {};
  EmSettings settings = fitted.settings;
  settings.noise = 0.6 * noise;
  return part.fit(pairs, settings, rival);
}

} // namespace

EmFit
doubleCurves(PartInWork& part)
{
  const EmSettings settings = part.best().settings;
  // In space, noise of one length may make another fit of it.
  const double rival = part.dimensions() == 3 ? std::numeric_limits<double>::infinity()
                                              : part.best().score;
  EmFit fit = doubledFit(part, part.best(), rival);
  const bool taken = part.take(fit, settings);
  // One curve between two explains their points badly, and a narrower bandwidth, that
  // leaves both in pieces, better; yet doubled it is both of them.
  ModelCurves last;
  for (const Fitted& other : part.traced()) {
    const ModelCurves& curves = other.fit.curves;
    if (curves.size() >= part.best().fit.curves.size() ||
        ofOneCourse(curves, last, other.fit.noise))
      continue;
    part.take(doubledFit(part, other, part.best().score), other.settings);
    last = curves;
  }
  return taken ? EmFit{} : fit;
}

void
rejoin(PartInWork& part)
{
  // What is joined in one place may show what is wrong in another.
  for (int round = 0; round < most_rejoinings && rejoinOnce(part); ++round) {
  }
}

void
traceTheRest(PartInWork& part, double widest_unit)
{
  const Points& points = part.points();
  const EmFit& best = part.best().fit;
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
    EmSettings settings = part.best().settings;
    settings.noise = std::max(best.noise, 0.25 * unit);
    if (!part.take(part.fit(start, settings), part.best().settings))
      break;
  }
}

void
followNoise(PartInWork& part, const ScaleField* scales)
{
  const EmFit& best = part.best().fit;
  if (best.curves.empty() ||
      best.peakedness <= least_tails * normalPeakedness(part.dimensions()))
    return;
  EmSettings settings = part.best().settings;
  settings.varied_noise = true;
  settings.noise = best.noise;
  if (!part.take(part.fit(best.curves, settings), settings))
    return;
  part.vary(nullptr, true);
  for (std::size_t k = 0; k < bandwidths.size(); ++k)
    part.tryBandwidth(k);
  if (!scales)
    return;
  part.vary(scales, true);
  for (const std::size_t k : varied_bandwidths)
    part.tryBandwidth(k);
}

void
simplify(PartInWork& part)
{
  bool better = true;
  for (int round = 0; round < most_simplifications && better; ++round) {
    const EmFit best = part.best().fit;
    EmSettings settings = part.best().settings;
    if (!settings.varied_noise && !settings.scales)
      return;
    settings.noise = best.noise;
    better = false;
    for (const ModelCurves& start :
         simplerNetworks(best.curves, part.scaleUnit(), settings.scales)) {
      if (part.improve(start, settings, least_gain))
        better = true;
    }
  }
}

void
fitShell(PartInWork& part, const EmFit& other)
{
  const EmSettings settings = part.best().settings;
  if (part.best().fit.curves.empty() || settings.scales || part.dimensions() < 3)
    return;
  const EmFit normal = part.best().fit;
  for (const EmFit* start : {&normal, &other}) {
    if (start->curves.empty() || start->noise < least_shell * settings.least_noise ||
        start->peakedness > most_peakedness)
      continue;
    EmSettings shell = settings;
    shell.shell = std::sqrt(3.0) * start->noise;
    shell.noise = shell_width * shell.shell;
    shell.iterations = shell_iterations;
    part.take(part.fit(start->curves, shell, part.best().score), shell);
  }
  // What normal noise hides: a curve whose points lie beside it rather than around it.
  const EmFit& best = part.best().fit;
  const double noise = best.deviation();
  const ModelCurves pairs =
      doubled(best.curves, part.points(), part.grid(), 4 * noise, doubled_shell_spread);
  if (pairs.empty())
    return;
  EmSettings shell = settings;
  shell.shell = pair_share * std::sqrt(3.0) * noise;
  shell.noise = shell_width * shell.shell;
  shell.iterations = shell_iterations;
  part.take(part.fit(pairs, shell, part.best().score), shell);
}

void
arch(PartInWork& part)
{
  const EmFit& best = part.best().fit;
  EmSettings settings = part.best().settings;
  const double curves = static_cast<double>(best.curves.size());
  // Without noise the points say all of the shape.
  if (best.noise <= settings.least_noise ||
      best.freedom <= least_arched * (part.dimensions() - 1) * curves)
    return;
  settings.arched = true;
  settings.noise = best.noise;
  part.take(part.fit(best.curves, settings), settings, least_gain);
}

void
sharpen(PartInWork& part)
{
  const EmFit& best = part.best().fit;
  for (const double factor : bend_noise) {
    const double size =
        factor * std::max(best.deviation(), bend_unit * part.scaleUnit());
    const ModelCurves start = sharpened(best.curves, size);
    if (start.empty())
      continue;
    EmSettings settings = part.best().settings;
    settings.noise = best.noise;
    settings.shell = best.shell;
    settings.iterations = near_iterations;
    part.improve(start, settings, least_gain);
  }
}

} // namespace linelet
