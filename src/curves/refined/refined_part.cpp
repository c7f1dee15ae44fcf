// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "refined_part.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include <linelet/search/scale_unit.h>

#include "part_moves.h"
#include "thinned_part.h"

namespace linelet {

namespace {

// Where a bandwidth does that much worse than the best so far, those beyond it are not
// tried.
constexpr double hopeless_score = 60;
constexpr std::size_t least_part = 5;
// The bandwidth of a part this large is chosen by a few samples of neighbouring points.
constexpr std::size_t sampled_part = 60000;
constexpr std::size_t sample_size = 8000;
constexpr std::size_t samples = 3;
// In such a part, unexplained points whose scale unit is more than this, in D, are
// left: a fit of all points would begin with noise so wide that each is near
// everything.
constexpr double widest_rest = 15;
// Two fits are revised in parts up to this size, the second one where its score is
// behind by no more than this.
constexpr std::size_t revised_part = 5000;
constexpr double most_behind = 50;
// Networks with fewer ends or curves are tried in parts up to this size.
constexpr std::size_t simplified_part = 5000;
// Points so few may be too sparse for ridges, however even their spacing.
constexpr std::size_t spanned_part = 200;

/** \brief The bandwidth (its number) that fits best around a few points. */
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
      // Each by itself, so that all have a score of their own.
      PartInWork part(sample, unit, user, stop);
      part.tryBandwidth(k);
      scores[k] += part.best().score;
    }
  }
  return static_cast<std::size_t>(std::min_element(scores.begin(), scores.end()) -
                                  scores.begin());
}

/** \brief Tries the bandwidths one after the other. */
void
tryBandwidths(PartInWork& part, const std::function<void(double)>& progress)
{
  bool hopeless = false;
  for (std::size_t k = 0; k < bandwidths.size(); ++k) {
    if (k == first_upwards)
      hopeless = false;
    if (!hopeless) {
      const double score = part.tryBandwidth(k);
      hopeless = score > part.best().score + hopeless_score;
    }
    progress(static_cast<double>(k + 1) / (2.0 + bandwidths.size()));
  }
}

/** \brief Lets the best fit try other topologies.
 * \return the fit that \ref doubleCurves rejected */
EmFit
revise(PartInWork& part, const ScaleField* scales)
{
  const std::size_t size = part.points().size();
  const bool sampled = size > sampled_part;
  if (size <= simplified_part)
    simplify(part);
  EmFit rejected = doubleCurves(part);
  rejoin(part);
  if (size <= (scales ? simplified_part : spanned_part))
    part.trySpanning();
  constexpr double any = std::numeric_limits<double>::infinity();
  traceTheRest(part, sampled ? widest_rest * part.scaleUnit() : any);
  if (size <= simplified_part)
    simplify(part);
  return rejected;
}

/** \brief Lets the best fit try noise of one length, and corners. */
void
finish(PartInWork& part, const EmFit& rejected)
{
  fitShell(part, rejected);
  sharpen(part);
}

/** \brief Revises the runner-up of the bandwidths as well as the best fit: what is
 * behind at first is often ahead of it in the end. */
void
reviseBoth(PartInWork& part, const ScaleField* scales)
{
  const std::optional<Fitted> runner_up = part.runnerUp(most_behind);
  finish(part, revise(part, scales));
  if (!runner_up)
    return;
  const Fitted best = part.best();
  part.goOnFrom(*runner_up);
  finish(part, revise(part, scales));
  if (best.score <= part.best().score)
    part.goOnFrom(best);
}

} // namespace

EmFit
refinePart(const Points& points,
           const RefinedSettings& user,
           const ScaleField* scales,
           const std::function<bool()>& stop,
           const std::function<void(double)>& progress)
{
  const double scale_unit =
      points.size() < least_part ? 0 : scaleUnit(points, 1024, 1, 1);
  if (!(scale_unit > 0))
    return {};
  PartInWork part(points, scale_unit, user, stop);
  const double size = part.curveSize();
  if (size > 1)
    return refineThinned(points, size, user, stop, progress);
  if (size == 0)
    return {};

  // What costs many fits, or integrals of every pair, is no work for millions.
  const bool sampled = points.size() > sampled_part;
  if (sampled) {
    const std::size_t chosen = bandwidthOfSamples(points, part.grid(), user, stop);
    progress(0.4);
    part.tryBandwidth(chosen);
  }
  else {
    tryBandwidths(part, progress);
    if (scales) {
      part.vary(scales, false);
      for (const std::size_t k : varied_bandwidths)
        part.tryBandwidth(k);
    }
    arch(part);
    followNoise(part, scales);
  }
  if (points.size() <= revised_part)
    reviseBoth(part, scales);
  else {
    const EmFit rejected = revise(part, scales);
    if (!sampled)
      finish(part, rejected);
  }
  return part.release();
}

} // namespace linelet
