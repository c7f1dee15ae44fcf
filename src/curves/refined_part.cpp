// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/curves/refined_part.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <linelet/curves/corners.h>
#include <linelet/curves/curve_doubling.h>
#include <linelet/curves/curve_likeness.h>
#include <linelet/curves/junction_pairing.h>
#include <linelet/curves/junction_revision.h>
#include <linelet/curves/model_score.h>
#include <linelet/curves/ridge_trace.h>
#include <linelet/curves/simpler_networks.h>
#include <linelet/curves/thinned_part.h>
#include <linelet/search/scale_unit.h>

namespace linelet {

namespace {

// In D. From the middle down, then up; where a bandwidth does far worse than the best
// so far, those beyond it are not tried.
constexpr std::array<double, 6> bandwidths = {1, 0.7, 0.5, 1.4, 2, 2.8};
constexpr std::size_t first_upwards = 3;
// Where the spacing of the points varies, these bandwidths are tried once more, varying
// with it.
constexpr std::array<std::size_t, 3> varied_bandwidths = {0, 1, 3};
constexpr double hopeless_score = 60;
constexpr std::size_t least_part = 5;
// The bandwidth of a part this large is chosen by a few samples of neighbouring points.
constexpr std::size_t sampled_part = 60000;
constexpr std::size_t sample_size = 8000;
constexpr std::size_t samples = 3;
constexpr int most_rounds = 3;
// Networks with fewer ends or curves are tried in parts up to this size.
constexpr std::size_t simplified_part = 5000;
constexpr int most_simplifications = 8;
// Curves may be joined wrongly where they pass within so many standard deviations, or
// D.
constexpr double doubt_noise = 2;
constexpr double doubt_unit = 0.6;
constexpr double least_gain = 1; // of the score, by which another topology is better
// Bends within so many standard deviations, or D, may be corners.
constexpr std::array<double, 2> bend_noise = {1, 2};
constexpr double bend_unit = 0.5;
constexpr int corner_iterations = 8; // the start is near
// A curve is doubled where the variance of its points one way is this many times that
// the other way; for noise of one length it is smaller beside the distance of a pair.
constexpr double doubled_spread = 2;
constexpr double doubled_shell_spread = 1.3;
// Noise of one length is tried where the noise is that much wider than the least, with
// a width of this share of its length. The peakedness is 2 for normal noise.
constexpr double least_shell = 1.2;
constexpr double shell_width = 0.2;
constexpr double pair_share = 0.7; // of the noise of one curve, to begin with
constexpr double most_peakedness = 2.2;
constexpr std::size_t least_rest = 8;

// A part this large is looked at before it is worked on: where hardly any neighbourhood
// of sampled points is linear, it is a surface or a volume.
constexpr std::size_t large_part = 5000;

/** \brief The peakedness of normal noise (\ref EmFit): fourth moment over squared
 * second of the distance from a line. */
double
normalPeakedness(int dimensions)
{
  return dimensions == 3 ? 2 : 3;
}

/** \brief A fit and what it was made with. */
struct Fitted {
  EmFit fit;
  EmSettings settings;
  double score = 0;
};

/** \brief A part while it is worked on. */
class Part {
public:
  Part(const Points& points,
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

  /** \brief The size in D on which the part looks like curves: more than 1 where they
   * are thick beside the spacing of the points; 0: on none. */
  double
  curveSize() const
  {
    if (points_.size() <= large_part)
      return 1;
    for (const double size : {1.0, 2.5, 6.0, 15.0})
      if (looksLinear(points_, grid_, size * scale_unit_))
        return size;
    return 0;
  }

  Fitted&
  best()
  {
    return best_;
  }
  const UniformGrid&
  grid() const
  {
    return grid_;
  }

  double
  scaleUnit() const
  {
    return scale_unit_;
  }
  const Points&
  points() const
  {
    return points_;
  }
  int
  dimensions() const
  {
    return frame_.dimensions;
  }

  /** \brief Keeps \a fit if it is better by \a gain. \return whether it was */
  bool
  take(EmFit fit, const EmSettings& settings, double gain = 0)
  {
    const double score = scoreOf(fit, points_.size());
    if (fit.curves.empty() || !(score < best_.score - gain))
      return false;
    best_ = {std::move(fit), settings, score};
    return true;
  }

  EmFit
  fit(const ModelCurves& start,
      const EmSettings& settings,
      double rival = std::numeric_limits<double>::infinity())
  {
    return fitter_.fit(start, settings, rival);
  }

  /** \brief From here on lets bandwidth, spacing and noise vary by \a scales, and the
   * noise by itself. */
  void
  vary(const ScaleField* scales, bool noise)
  {
    scales_ = scales;
    varied_noise_ = noise;
  }

  /** \brief Traces and fits with bandwidth number \a k.
   * \return the score; where nothing new was to be fitted, that of the best */
  double
  tryBandwidth(std::size_t k)
  {
    const double unit = scales_ ? scales_->unit() : scale_unit_;
    const double b = bandwidths[k] * unit;
    const RidgeField field(points_, b, scales_);
    const Traces traces =
        traceRidges(field, {user_.start_points, user_.max_iterations});
    double local = scales_ && !traces.meetings.empty() ? 0 : b; // where curves meet
    if (local == 0)
      for (const Point& meeting : traces.meetings)
        local +=
            field.bandwidthAt(meeting) / static_cast<double>(traces.meetings.size());
    PairingSettings pairing;
    pairing.cluster = 2.5 * local;
    pairing.cut = 1.25 * local;
    pairing.reach = 3 * local;
    ModelCurves start = pairArms(traces.curves, traces.meetings, pairing);
    const bool alike = best_.settings.scales == scales_ &&
                       best_.settings.varied_noise == varied_noise_;
    if (start.empty() ||
        (alike && !best_.fit.curves.empty() && leadsTo(best_.fit, start, b)))
      return best_.score;
    for (ModelCurve& curve : start)
      curve.scale = std::min(field.bandwidthAt(curve.nodes.front()),
                             field.bandwidthAt(curve.nodes.back()));
    EmSettings settings;
    settings.scales = scales_;
    settings.spacing = std::max(0.4 * unit, 0.24 * b);
    settings.noise = 0.5 * b;
    settings.least_noise = 0.1 * unit;
    settings.bending = 1 / frame_.diagonal;
    settings.varied_noise = varied_noise_;
    EmFit fit = fitter_.fit(start, settings, best_.score);
    const double score = scoreOf(fit, points_.size());
    take(std::move(fit), settings);
    return score;
  }

private:
  const Points& points_;
  double scale_unit_;
  CloudFrame frame_;
  UniformGrid grid_;
  EmFitter fitter_;
  const RefinedSettings& user_;
  const ScaleField* scales_ = nullptr;
  bool varied_noise_ = false;
  Fitted best_;
};

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
      Part part(sample, unit, user, stop);
      part.tryBandwidth(k);
      scores[k] += part.best().score;
    }
  }
  return static_cast<std::size_t>(std::min_element(scores.begin(), scores.end()) -
                                  scores.begin());
}

/** \brief Tries other ways to join the curves of the best fit, on two scales.
 * \return whether one of them is better */
bool
rejoin(Part& part)
{
  bool better = false;
  const EmFit& best = part.best().fit;
  for (const double factor : {1.0, 2.0})
    for (const Rejoining rejoining : {Rejoining::Paired, Rejoining::Bridged}) {
      const double size =
          factor * std::max(doubt_noise * best.noise, doubt_unit * part.scaleUnit());
      const ModelCurves start = rejoined(best.curves, size, rejoining);
      if (start.empty())
        continue;
      EmSettings settings = part.best().settings;
      settings.noise = best.noise;
      const double rival = part.best().score;
      if (part.take(part.fit(start, settings, rival), part.best().settings, least_gain))
        better = true;
    }
  return better;
}

/** \brief Tries sharp corners where the curves of the best fit bend strongly. */
void
sharpen(Part& part)
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
    settings.iterations = corner_iterations;
    const double rival = part.best().score;
    part.take(part.fit(start, settings, rival), part.best().settings, least_gain);
  }
}

/** \brief Where the noise seems to vary along the curves, lets it, and chooses among
 * the bandwidths once more. */
void
followNoise(Part& part, const ScaleField* scales)
{
  const EmFit& best = part.best().fit;
  if (best.curves.empty() || best.peakedness <= normalPeakedness(part.dimensions()))
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

/** \brief Tries networks with fewer free ends or curves where spacing or noise vary, so
 * that no bandwidth follows the curves all along. */
void
simplify(Part& part)
{
  bool better = true;
  for (int round = 0; round < most_simplifications && better; ++round) {
    const EmFit best = part.best().fit;
    EmSettings settings = part.best().settings;
    if (!settings.varied_noise && !settings.scales)
      return;
    settings.noise = best.noise;
    better = false;
    for (const ModelCurves& start : simplerNetworks(best.curves, part.scaleUnit())) {
      const double rival = part.best().score;
      if (part.take(part.fit(start, settings, rival), part.best().settings, least_gain))
        better = true;
    }
  }
}

/** \brief Fits noise of one length where the distances of the points may be such, to
 * the best fit and to \a other, which normal noise has rejected. */
void
fitShell(Part& part, const EmFit& other)
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
    part.take(part.fit(start->curves, shell), shell);
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
  part.take(part.fit(pairs, shell), shell);
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
  Part part(points, scale_unit, user, stop);
  const double size = part.curveSize();
  if (size > 1)
    return refineThinned(points, size, user, stop, progress);
  if (size == 0)
    return {};
  if (points.size() > sampled_part) {
    const std::size_t chosen = bandwidthOfSamples(points, part.grid(), user, stop);
    progress(0.4);
    part.tryBandwidth(chosen);
  }
  else {
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
  if (scales && points.size() <= sampled_part) {
    part.vary(scales, false);
    for (const std::size_t k : varied_bandwidths)
      part.tryBandwidth(k);
  }
  if (points.size() <= sampled_part)
    followNoise(part, scales);
  if (points.size() <= simplified_part)
    simplify(part);
  // Close parallel curves are traced as one.
  EmFit other;
  EmFit& best = part.best().fit;
  const ModelCurves pairs =
      doubled(best.curves, points, part.grid(), 4 * best.noise, doubled_spread);
  if (!pairs.empty()) {
    EmSettings settings = part.best().settings;
    settings.noise = 0.6 * best.noise;
    other = part.fit(pairs, settings);
    if (part.take(other, part.best().settings))
      other = {};
  }

  for (int round = 0; round < most_rounds && points.size() <= sampled_part; ++round)
    if (!rejoin(part))
      break;

  // What the fit leaves unexplained may be a sparser part of a curve.
  for (int round = 0; round < most_rounds && !best.curves.empty(); ++round) {
    Points rest;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (best.outlier[i] > 0.5)
        rest.push_back(points[i]);
    if (rest.size() < least_rest)
      break;
    const double unit = scaleUnit(rest, 1024, 1, 1);
    if (!(unit > 0))
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
  if (points.size() <= simplified_part)
    simplify(part);
  if (points.size() <= sampled_part) {
    fitShell(part, other); // integrals of every pair: no work for millions
    sharpen(part);
  }
  return std::move(best);
}

} // namespace linelet
