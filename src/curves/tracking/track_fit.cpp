// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "track_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <mutex>
#include <utility>

#include "cross_section.h"
#include "curves/mixture/model_score.h"
#include "lines_of_track.h"
#include "points_around.h"
#include "support/parallel_chunks.h"

namespace linelet {

namespace {

constexpr double track_reach = 4; // standard deviations, of the points around a track
constexpr double node_spacing = 3.6; // spacings of the points, as of a cloud of curves
constexpr double local_unit = 3;     // spacings: the sixth neighbor on a line, D there
constexpr double least_noise = 0.02; // D of the scene
// Prior variance of the angle by which a curve turns over its length: freely, and like
// a wire that hangs in a span.
constexpr double free_turn = 1, slight_turn = 1e-3;
// Lines side by side are looked for where the noise is this many times the least, and
// taken if each of them improves the criterion by this much: their offsets were chosen
// among many.
constexpr double least_thick = 4, least_gain = 6;
// In largest distances of the fitted points: where the background begins and ends; and
// the factor by which that distance grows if the noise is wider than the filter
// assumed.
constexpr double background_from = 2, background_to = 3, widening = 1.3;
// A count that exceeds its expectation by this many standard deviations does not do so
// by chance.
constexpr double noticed = 3;

/** \brief The path of the filter at equal steps, each the mean of its places. */
ModelCurve
smoothPath(const Track& track, double spacing)
{
  ModelCurve curve;
  double walked = 0;
  Point sum = Point::Zero();
  double count = 0;
  for (std::size_t k = 0; k < track.path.size(); ++k) {
    sum += track.path[k];
    count += 1;
    const double step =
        k + 1 < track.path.size() ? (track.path[k + 1] - track.path[k]).norm() : 0;
    walked += step;
    if (walked < spacing && k + 1 < track.path.size())
      continue;
    curve.nodes.push_back(curve.nodes.empty() ? track.path.front()
                                              : Point(sum / count));
    sum.setZero();
    count = walked = 0;
  }
  if (curve.nodes.size() < 2)
    curve.nodes = {track.path.front(), track.path.back()};
  else
    curve.nodes.back() = track.path.back();
  return curve;
}

/** \brief Mean square of the offsets of the places of \a track from \a curve, nodes
 * along it, per coordinate across. */
double
squaredDeparture(const Track& track, const ModelCurve& curve)
{
  double sum = 0;
  std::size_t e = 0;
  for (const Point& p : track.path) {
    while (e + 1 < curve.edges() &&
           squaredDistance(curve, e + 1, p) <= squaredDistance(curve, e, p))
      ++e;
    sum += squaredDistance(curve, e, p);
  }
  return sum / (2 * static_cast<double>(track.path.size()));
}

/** \brief Cross section of a tube between two radii, up to a factor. */
double
ringArea(double from, double to)
{
  return to * to - from * from;
}

/** \brief \a count, or more by what chance may add. */
double
atMost(double count)
{
  return count + noticed * std::sqrt(std::max(count, 1.0));
}

/** \brief Fits the same points in several threads at a time, each with a fitter whose
 * memory is used again. */
class SharedFitter {
public:
  explicit SharedFitter(std::function<std::unique_ptr<EmFitter>()> make)
      : make_(std::move(make))
  {
  }

  EmFit
  fit(const ModelCurves& curves, const EmSettings& settings)
  {
    std::unique_ptr<EmFitter> fitter;
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      if (!idle_.empty()) {
        fitter = std::move(idle_.back());
        idle_.pop_back();
      }
    }
    if (!fitter)
      fitter = make_();
    EmFit result = fitter->fit(curves, settings);
    const std::lock_guard<std::mutex> lock(mutex_);
    idle_.push_back(std::move(fitter));
    return result;
  }

private:
  std::function<std::unique_ptr<EmFitter>()> make_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<EmFitter>> idle_;
};

/** \brief The points around a track, and how they are fitted. */
struct FitInput {
  const Points& points;
  const UniformGrid& grid;
  SharedFitter& fitter;
  const EmSettings& settings;
  unsigned threads;

  double
  score(const EmFit& fit) const
  {
    return scoreOf(fit, points.size());
  }
};

/** \brief Log-likelihood of \a fit, less its parameters, if its points may scatter as
 * over ribbons, which a wide beam makes. */
double
gainOverRibbons(const EmFit& fit, const FitInput& input)
{
  return unevenScatterGain(fit, input.points, input.grid, input.settings.least_noise) -
         0.5 * input.score(fit);
}

/** \brief A single curve, and lines side by side along it. */
struct CurveAndLines {
  EmFit one;
  double gain = 0; ///< of ribbons along it
  std::vector<ParallelLines> lines;
  std::vector<EmFit> fits; ///< of each of these
};

/** \brief Looks for lines along \a one and fits them. */
CurveAndLines
linesBeside(EmFit one, const FitInput& input)
{
  CurveAndLines result;
  result.gain = gainOverRibbons(one, input);
  result.lines = linesAlong(
      one.curves.front(), input.points, one.noise, input.settings.least_noise);
  result.fits.resize(result.lines.size());
  forEachChunk(result.lines.size(), 1, input.threads, [&](std::size_t k, std::size_t) {
    EmSettings thin = input.settings;
    thin.noise = result.lines[k].width;
    result.fits[k] = input.fitter.fit(result.lines[k].curves, thin);
  });
  result.one = std::move(one);
  return result;
}

/** \brief Takes the lines along a curve where they explain more than \a best and than
 * ribbons, of which one has \a gain_of_one: either where each goes its own way, or as
 * modes of one cross-section. */
void
takeLines(CurveAndLines& along, double gain_of_one, const FitInput& input, EmFit& best)
{
  for (std::size_t k = 0; k < along.fits.size(); ++k) {
    EmFit& fit = along.fits[k];
    if (fit.curves.empty())
      continue;
    const double needed = least_gain * (static_cast<double>(fit.curves.size()) - 1);
    if (input.score(fit) < input.score(best) - needed &&
        (gainOverRibbons(fit, input) > gain_of_one + 0.5 * needed ||
         modesGain(along.one,
                   along.lines[k].offsets,
                   input.points,
                   input.grid,
                   input.settings.least_noise) > 0.5 * needed))
      best = std::move(fit);
  }
}

/** \brief The best of \a single and of lines side by side along it. */
EmFit
linesInstead(const EmFit& single,
             bool clear,
             const EmSettings& stiff,
             const FitInput& input)
{
  std::array<CurveAndLines, 2> along;
  forEachChunk(clear ? 2 : 1, 1, input.threads, [&](std::size_t k, std::size_t) {
    // A free curve may wander between the lines; a stiff one keeps its course.
    EmFit one = k == 0 ? single : input.fitter.fit(single.curves, stiff);
    if (one.curves.size() == 1)
      along[k] = linesBeside(std::move(one), input);
  });
  EmFit best = single;
  takeLines(along[0], along[0].gain, input, best);
  takeLines(along[1], std::max(along[0].gain, along[1].gain), input, best);
  return best;
}

} // namespace

TrackFitter::TrackFitter(const TrackedScene& scene,
                         const Track& track,
                         bool clear,
                         unsigned threads,
                         std::function<bool()> stop)
    : scene_(scene),
      track_(track),
      clear_(clear),
      threads_(threads),
      stop_(std::move(stop)),
      start_(smoothPath(track, node_spacing / track.density))
{
  start_.scale = local_unit / track.density;
  // With few points, nodes lie far apart and cut corners.
  distance_ = track_reach *
              std::sqrt(track.noise * track.noise + squaredDeparture(track, start_));
}

TrackFit
TrackFitter::toSurroundings() const
{
  const double reach = background_from * distance_;
  const PointsAround around(scene_, start_, reach);
  const double background = around.count(distance_, reach) * ringArea(0, distance_) /
                            ringArea(distance_, reach);
  return fit(around.within(distance_), background);
}

TrackFit
TrackFitter::toMembers() const
{
  Indices members;
  for (const Track::Member& m : track_.members)
    if (m.weight > 0.5)
      members.push_back(m.index);
  const auto count = static_cast<double>(members.size());
  return fit(std::move(members), count);
}

bool
TrackFitter::widen()
{
  const double wider = widening * distance_, narrower = distance_ / widening;
  const double from = background_from * distance_, to = background_to * distance_;
  const PointsAround around(scene_, start_, to);
  const double inside = around.count(narrower, distance_);
  const double outside = around.count(distance_, wider);
  const double background =
      around.count(from, to) * ringArea(distance_, wider) / ringArea(from, to);
  const bool go_on =
      outside > atMost(background) &&
      inside / ringArea(narrower, distance_) >= outside / ringArea(distance_, wider);
  if (go_on)
    distance_ = wider;
  return go_on;
}

TrackFit
TrackFitter::fit(Indices indices, double background) const
{
  TrackFit result;
  result.points = std::move(indices);
  ModelCurve start = start_;
  const Point origin = start.nodes.front();
  for (Point& node : start.nodes)
    node -= origin;
  Points points;
  for (const Index i : result.points)
    points.push_back(scene_.points()[i] - origin);
  CloudFrame frame;
  frame.scale_unit = local_unit / track_.density;
  frame.diagonal = length(start);
  frame.volume = M_PI * distance_ * distance_ * length(start);
  frame.dimensions = 3;
  const UniformGrid grid(points, std::max(distance_, 2 * track_.noise));
  SharedFitter fitter(
      [&] { return std::make_unique<EmFitter>(points, grid, frame, stop_); });
  EmSettings settings;
  const auto count = static_cast<double>(points.size());
  settings.outlier_share = std::clamp(1 - track_.weight() / count, 0.01, 0.99);
  settings.most_outliers = atMost(background) / count;
  settings.noise = track_.noise;
  settings.least_noise = least_noise * scene_.unit;
  settings.spacing = node_spacing / track_.density;
  settings.bending = free_turn / frame.diagonal;
  const FitInput input = {points, grid, fitter, settings, threads_};
  result.fit = fitter.fit({start}, settings);
  EmSettings stiff = settings;
  stiff.bending = slight_turn / frame.diagonal;
  stiff.noise = result.fit.noise;
  if (result.fit.curves.size() == 1 &&
      result.fit.noise >= least_thick * settings.least_noise)
    result.fit = linesInstead(result.fit, clear_, stiff, input);
  if (!result.fit.curves.empty()) {
    // With few noisy points, a stiffer curve may score better.
    stiff.noise = result.fit.noise;
    EmFit fit = fitter.fit(result.fit.curves, stiff);
    if (!fit.curves.empty() && input.score(fit) < input.score(result.fit))
      result.fit = std::move(fit);
  }
  for (const double outlier : result.fit.outlier)
    result.explained.push_back(outlier < 0.5);
  for (ModelCurve& curve : result.fit.curves)
    for (Point& node : curve.nodes)
      node += origin;
  return result;
}

} // namespace linelet
