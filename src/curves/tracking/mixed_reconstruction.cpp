// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "mixed_reconstruction.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "curves/ridges/distinct_points.h"
#include "direction_seeds.h"
#include "explained_points.h"
#include "hidden_stretches.h"
#include "parallel_seeds.h"
#include "seed_groups.h"
#include "support/parallel_chunks.h"
#include "track_fit.h"
#include "track_seeds.h"

namespace linelet {

namespace {

// Seeds that are followed at a time from a cell of this side, in D; the best of them
// claims its points first.
constexpr std::size_t group_size = 8;
constexpr double group_side = 30;
// In D: closer points carry no more information than one of them.
constexpr double least_distance = 0.25;
// Radians per 10 points.
constexpr TrackBending stiff = {0.01, 10}, flexible = {0.15, 10};
// In clutter, the points around a seed spread wider than the curve that it lies on.
constexpr double narrower = 0.25;
// Log-likelihood ratios: needed by a curve, beyond the logarithm of the number of
// points, which the best of so many starts reaches by chance; needed per point on
// average; and allowed to be lost where the curve is hidden.
constexpr double least_evidence = 20, least_per_point = 0.5, patience = 12;
// Share of the evidence needed that the first passes must give.
constexpr double promising = 0.5;
// In spacings of its points: the longest gap between visible stretches of a curve.
constexpr double widest_gap = 150;
// Share of its points that no other curve may have claimed.
constexpr double least_free = 0.8;
// A refit that loses more of the length than this was misled by its surroundings, if
// the evidence is this many times what is needed.
constexpr double least_kept = 0.7, sure = 1.6, very_sure = 5;
// Largest noise of a curve, in geometric means of its length and the spacing of its
// points, unless it stands out very clearly: the wider it is for its spacing, the
// longer it must be. Of the tracks looked at, in scenes of two simulators, nine tenths
// of the strips of surfaces and crowns lie above, and 6 % of the wires.
constexpr double widest = 1.0 / 30;

// Largest noise of a curve, relative to that of its scene; a noisier one must stand out
// very clearly, and by as many times more as it is noisier. With 2 or 5 as many wires
// are found in simulated scenes; 5 leaves more clutter.
constexpr double widest_of_scene = 3;

// Times that a fit takes in more points around it, at most.
constexpr int most_widenings = 3;

// What runs along a surface is not a curve of its own either, unless it is very sure:
// within this many D, and beyond the curve's own scatter, on most of its length.
constexpr double beside = 1.5, most_on_surface = 0.5;

// Points of a curve, at least, and relative to those of its track, at most: a fit of
// more has left the track for what lies around it. In scenes of a second simulator, 117
// m of 194 km of true curves had fewer than 6 points, and so had 15 of 48 false ones;
// none explained more than three times its track's.
constexpr double fewest_points = 6, most_beyond = 3;

// A single curve that explains more than this share of a track's points, with less than
// this share of the track's noise, winds from point to point of clutter.
constexpr double most_of_track = 0.5, winding = 0.1;

double
lengthOf(const Points& path)
{
  double sum = 0;
  for (std::size_t k = 1; k < path.size(); ++k)
    sum += (path[k] - path[k - 1]).norm();
  return sum;
}

double
countOf(const EmFit& fit)
{
  double sum = 0;
  for (const std::vector<double>& counts : fit.counts)
    sum = std::accumulate(counts.begin(), counts.end(), sum);
  return sum;
}

// Share of \a curves right beside which a surface lies: such a curve is its edge, or a
// row of its points. Its own points are not counted, nor are those of curves found
// before, although wires side by side look like a surface from them.
double
shareOnSurface(const TrackedScene& scene, const ModelCurves& curves, double noise)
{
  const double own = own_width * noise;
  const double reach = std::max(beside * scene.unit, 2 * own);
  double on = 0, all = 0;
  for (const ModelCurve& curve : curves)
    for (std::size_t k = 1; k < curve.nodes.size(); ++k) {
      const Point way = curve.nodes[k] - curve.nodes[k - 1];
      const Point direction = way.normalized();
      const double steps = std::max(1.0, std::ceil(way.norm() / reach));
      for (double i = 0; i < steps; ++i) {
        const Point p = curve.nodes[k - 1] + (i + 0.5) / steps * way;
        bool near = false;
        scene.grid.forEachRun(p, reach, [&](std::size_t begin, std::size_t end) {
          for (std::size_t j = begin; j < end && !near; ++j) {
            const Point v = scene.points()[j] - p;
            near = scene.surface[j] != 0 && !scene.taken[j] &&
                   v.squaredNorm() <= reach * reach &&
                   (v - direction.dot(v) * direction).squaredNorm() > own * own;
          }
        });
        on += near ? way.norm() / steps : 0;
        all += way.norm() / steps;
      }
    }
  return all > 0 ? on / all : 0;
}

/** \brief Noise of a scene's curves: the sensor's, or the size of bundles. A median by
 * evidence, so that the clearest curves decide. */
double
typicalNoise(const ModelCurves& curves)
{
  std::vector<std::pair<double, double>> noise_evidence;
  double all = 0;
  for (const ModelCurve& curve : curves) {
    noise_evidence.emplace_back(curve.noise, curve.evidence);
    all += curve.evidence;
  }
  std::sort(noise_evidence.begin(), noise_evidence.end());
  double sum = 0;
  for (const auto& [noise, evidence] : noise_evidence) {
    sum += evidence;
    if (sum >= 0.5 * all)
      return noise;
  }
  return 0;
}

/** \brief Drops the curves that are much noisier than the others, and not \a clear by
 * as much: clutter lines up by chance, but not as narrowly as curves are. */
ModelCurves
withoutThickOnes(ModelCurves curves, double clear)
{
  const double most_noise = widest_of_scene * typicalNoise(curves);
  curves.erase(std::remove_if(curves.begin(),
                              curves.end(),
                              [&](const ModelCurve& curve) {
                                return curve.noise > most_noise &&
                                       curve.evidence <
                                           clear * curve.noise / most_noise;
                              }),
               curves.end());
  return curves;
}

/** \brief Follows curves from seeds, and keeps track of what they explain. */
class SceneCurves {
public:
  SceneCurves(TrackedScene& scene,
              const RefinedSettings& settings,
              double points,
              ProgressMonitor* monitor)
      : scene_(scene),
        settings_(settings),
        least_(evidenceNeeded(points)),
        monitor_(monitor)
  {
  }

  void
  follow(const std::vector<TrackSeed>& seeds,
         const TrackBending& bending,
         double times_needed = 1)
  {
    needed_ = times_needed * least_;
    failed_.assign(scene_.points().size(), 0);
    SeedGroups groups(seeds, group_side * scene_.unit);
    const auto is_open = [&](const TrackSeed& seed) {
      return !scene_.taken[seed.index] && !failed_[seed.index];
    };
    std::size_t tried = 0, told = 0; // to the monitor
    const std::size_t most =
        settings_.start_points > 0 ? settings_.start_points : seeds.size();
    for (;;) {
      const std::vector<TrackSeed> group =
          groups.next(std::min(group_size, most - tried), is_open);
      if (group.empty())
        break;
      tried += group.size();
      takeBest(group, tracksFrom(group, bending));
      if (monitor_)
        monitor_->advance(groups.passed() - told);
      told = groups.passed();
    }
    if (monitor_)
      monitor_->advance(seeds.size() - told);
  }

  const ModelCurves&
  found() const
  {
    return curves_;
  }

  ModelCurves
  release()
  {
    curves_ = withoutThickOnes(std::move(curves_), clear_);
    return withoutExplained(scene_, std::move(curves_), least_);
  }

private:
  bool
  stopped() const
  {
    return monitor_ && monitor_->canceled();
  }

  std::vector<Track>
  tracksFrom(const std::vector<TrackSeed>& group, const TrackBending& bending) const
  {
    std::vector<Track> tracks(group.size());
    forEachChunk(group.size(), 1, settings_.threads, [&](std::size_t k, std::size_t) {
      for (const double width : {1.0, narrower}) {
        if (tracks[k].evidence >= clear_)
          break;
        TrackSeed seed = group[k];
        seed.noise *= width;
        Track track = followCurve(scene_,
                                  seed,
                                  bending,
                                  patience,
                                  settings_.max_iterations,
                                  promising * needed_);
        if (track.evidence > tracks[k].evidence)
          tracks[k] = std::move(track);
      }
    });
    return tracks;
  }

  void
  takeBest(const std::vector<TrackSeed>& group, const std::vector<Track>& tracks)
  {
    std::vector<std::size_t> order(tracks.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return tracks[a].evidence > tracks[b].evidence;
    });
    for (const std::size_t k : order) {
      if (stopped())
        throw Canceled();
      if (take(tracks[k]))
        continue;
      failed_[group[k].index] = 1;
      for (const Track::Member& m : tracks[k].members)
        if (m.weight > 0.5 && !scene_.taken[m.index])
          failed_[m.index] = 1;
    }
  }

  /** \brief Whether \a fit is one or more curves that \a track followed. */
  bool
  isCurve(const EmFit& fit, const Track& track, bool clear) const
  {
    const double count = countOf(fit), of_track = track.weight();
    if (fit.curves.empty() || count < fewest_points || count > most_beyond * of_track)
      return false;
    if (fit.curves.size() == 1 && count > most_of_track * of_track &&
        fit.spread < winding * track.noise)
      return false;
    return clear || (fit.noise * std::sqrt(count) <= widest * length(fit.curves) &&
                     shareOnSurface(scene_, fit.curves, fit.noise) <= most_on_surface);
  }

  /** \return false where \a track is no curve */
  bool
  take(const Track& track)
  {
    const double total = track.weight();
    double free = 0;
    for (const Track::Member& m : track.members)
      free += scene_.taken[m.index] ? 0 : m.weight;
    if (track.evidence < std::max(needed_, least_per_point * total))
      return false;
    if (free < least_free * total)
      return true; // of another curve, found meanwhile
    const bool clear = track.evidence >= clear_;
    TrackFitter fitter(
        scene_, track, clear, settings_.threads, [this] { return stopped(); });
    TrackFit fit = fitter.toSurroundings();
    const bool misled = length(fit.fit.curves) < least_kept * lengthOf(track.path) &&
                        track.evidence > sure * needed_;
    if (misled)
      fit = fitter.toMembers();
    if (!isCurve(fit.fit, track, clear))
      return false;
    for (int k = 0; k < most_widenings && !misled; ++k) {
      if (fit.fit.curves.size() > 1 || !fitter.widen())
        break;
      TrackFit wider = fitter.toSurroundings();
      if (wider.fit.curves.empty())
        break;
      if (!isCurve(wider.fit, track, clear))
        return false;
      fit = std::move(wider);
    }
    explainPoints(scene_, track, fit, clear);
    for (std::size_t c = 0; c < fit.fit.curves.size(); ++c) {
      ModelCurve& curve = fit.fit.curves[c];
      curve.counts = std::move(fit.fit.counts[c]);
      curve.noise = fit.fit.spread;
      const double own = std::accumulate(curve.counts.begin(), curve.counts.end(), 0.0);
      // The points of lines side by side tell as much as those of the track between.
      curve.evidence =
          fit.fit.curves.size() > 1 ? track.evidence * own / total : track.evidence;
      if (c == 0 || curve.evidence >= needed_) // else strays beside the others
        curves_.push_back(std::move(curve));
    }
    return true;
  }

  TrackedScene& scene_;
  const RefinedSettings& settings_;
  double least_; // evidence needed by any curve of the whole cloud
  double clear_ = very_sure * least_;
  ProgressMonitor* monitor_;
  double needed_ = 0;        // evidence, of the curves that are followed now
  std::vector<char> failed_; // per point, whether a failed start passed it
  ModelCurves curves_;
};

} // namespace

double
evidenceNeeded(double points)
{
  return least_evidence + std::log(points);
}

ModelCurves
mixedCurves(const Points& all,
            double unit,
            const RefinedSettings& settings,
            ProgressMonitor* monitor)
{
  TrackedScene scene(onePerCell(all, least_distance * unit), unit);
  const SceneSeeds seeds = measureScene(scene, settings.threads, monitor);
  if (monitor)
    monitor->begin("curves",
                   (settings.only_stiff ? 1 : 2) * seeds.open.size() +
                       seeds.on_sparse_surfaces.size());
  // Of the whole cloud, if this is a part of it.
  const double points = settings.whole.points > 0
                            ? settings.whole.points
                            : static_cast<double>(scene.points().size());
  SceneCurves curves(scene, settings, points, monitor);
  // These come first: what they explain no longer misleads the others.
  curves.follow(seeds.open, stiff);
  if (!settings.only_stiff)
    curves.follow(seeds.open, flexible);
  // Very clear curves show that what looked like a sparse surface is not one.
  for (const Index i : seeds.sparse_surfaces)
    scene.surface[i] = 0;
  curves.follow(seeds.on_sparse_surfaces, stiff, very_sure);
  const std::vector<TrackSeed> sparse =
      seedsAlongDirections(scene, points, settings.threads, monitor);
  if (monitor)
    monitor->begin("sparse curves", sparse.size());
  curves.follow(sparse, stiff, sure);
  const std::vector<TrackSeed> parallel =
      seedsAlongCurves(scene, curves.found(), widest_gap, settings.threads, monitor);
  if (monitor)
    monitor->begin("parallel curves", parallel.size());
  curves.follow(parallel, stiff);
  return settings.distance_cutoff > 0
             ? joinHiddenStretches(
                   curves.release(), widest_gap, settings.distance_cutoff)
             : joinHiddenStretches(curves.release(), widest_gap);
}

} // namespace linelet
