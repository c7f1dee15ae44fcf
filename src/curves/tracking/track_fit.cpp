// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "track_fit.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "cross_section.h"
#include "curves/mixture/model_score.h"
#include "lines_of_track.h"

namespace linelet {

namespace {

constexpr double track_reach = 4; // standard deviations, of the points around a track
constexpr double node_spacing = 3.6; // spacings of the points, as of a cloud of curves
constexpr double local_unit = 3;     // spacings: the sixth neighbor on a line, D there
constexpr double least_noise = 0.02; // D of the scene
// Squares of the angles by which a curve is thought to turn over its length, before its
// points tell: freely, and like a wire that hangs in a span.
constexpr double free_turn = 1, slight_turn = 1e-3;
// Lines side by side are looked for where the noise is this many times the least, and
// taken where each of them improves the criterion by so much: their offsets were chosen
// among many.
constexpr double least_thick = 4, least_gain = 6;

/** \brief The way of the filter at equal steps, each the mean of the places there. */
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

/** \brief The points within \a distance of \a curve that no other one explains. */
Indices
pointsAround(const TrackedScene& scene, const ModelCurve& curve, double distance)
{
  Indices result;
  for (std::size_t e = 0; e < curve.edges(); ++e) {
    const Point cap =
        distance * (curve.to(e) - curve.from(e)).stableNormalized(); // rounds the end
    scene.grid.forEachRunInCylinder(
        curve.from(e) - cap,
        curve.to(e) + cap,
        distance,
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t i = begin; i < end; ++i)
            if (!scene.taken[i] &&
                squaredDistance(curve, e, scene.points()[i]) <= distance * distance)
              result.push_back(static_cast<Index>(i));
        });
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

} // namespace

TrackFit
fitTrack(const TrackedScene& scene,
         const Track& track,
         FitTo fit_to,
         const std::function<bool()>& stop)
{
  TrackFit result;
  const double spacing = node_spacing / track.density;
  ModelCurve start = smoothPath(track, spacing);
  start.scale = local_unit / track.density;
  // Of few points, nodes lie far apart and cut the bends between them.
  const double distance = track_reach * std::sqrt(track.noise * track.noise +
                                                  squaredDeparture(track, start));
  if (fit_to == FitTo::Members) {
    for (const Track::Member& m : track.members)
      if (m.weight > 0.5)
        result.points.push_back(m.index);
  }
  else
    result.points = pointsAround(scene, start, distance);
  const Point origin = start.nodes.front();
  for (Point& node : start.nodes)
    node -= origin;
  Points points;
  for (const Index i : result.points)
    points.push_back(scene.points()[i] - origin);
  CloudFrame frame;
  frame.scale_unit = local_unit / track.density;
  frame.diagonal = length(start);
  frame.volume = M_PI * distance * distance * length(start);
  frame.dimensions = 3;
  const UniformGrid grid(points, std::max(distance, 2 * track.noise));
  EmFitter fitter(points, grid, frame, stop);
  EmSettings settings;
  double members = 0;
  for (const Track::Member& m : track.members)
    members += m.weight;
  settings.outlier_share =
      std::clamp(1 - members / static_cast<double>(points.size()), 0.01, 0.99);
  settings.noise = track.noise;
  settings.least_noise = least_noise * scene.unit;
  settings.spacing = spacing;
  settings.bending = free_turn / frame.diagonal;
  result.fit = fitter.fit({start}, settings);
  const EmFit one = result.fit;
  // Where a wide beam makes ribbons, lines side by side must tell more than these:
  // either where each goes its own way, or as modes of one cross-section.
  std::optional<double> gain_of_one;
  const auto beatRibbons = [&](const ParallelLines& lines, const EmFit& fit) {
    const double needed =
        0.5 * least_gain * (static_cast<double>(fit.curves.size()) - 1);
    const auto gain = [&](const EmFit& of) {
      return unevenScatterGain(of, points, grid, settings.least_noise) -
             0.5 * scoreOf(of, points.size());
    };
    if (!gain_of_one)
      gain_of_one = gain(one);
    return gain(fit) > *gain_of_one + needed ||
           modesGain(one, lines.offsets, points, grid, settings.least_noise) > needed;
  };
  double best = scoreOf(result.fit, points.size());
  if (result.fit.curves.size() == 1 &&
      result.fit.noise >= least_thick * settings.least_noise)
    for (const ParallelLines& lines : linesAlong(result.fit.curves.front(),
                                                 points,
                                                 result.fit.noise,
                                                 settings.least_noise)) {
      EmSettings thin = settings;
      thin.noise = lines.width;
      EmFit fit = fitter.fit(lines.curves, thin);
      const double score = scoreOf(fit, points.size());
      const double extra = static_cast<double>(fit.curves.size()) - 1;
      if (fit.curves.empty() || score >= best - least_gain * extra ||
          !beatRibbons(lines, fit))
        continue;
      best = score;
      result.fit = std::move(fit);
    }
  if (!result.fit.curves.empty()) {
    // Of few noisy points, a stiffer curve may say more.
    EmSettings stiff = settings;
    stiff.bending = slight_turn / frame.diagonal;
    stiff.noise = result.fit.noise;
    EmFit fit = fitter.fit(result.fit.curves, stiff);
    if (!fit.curves.empty() && scoreOf(fit, points.size()) < best)
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
