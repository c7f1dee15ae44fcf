// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/curves/refined_part.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_01.hpp>
#include <Eigen/Eigenvalues>

#include <linelet/curves/junction_pairing.h>
#include <linelet/curves/junction_revision.h>
#include <linelet/curves/model_score.h>
#include <linelet/curves/ridge_trace.h>
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
// A curve is doubled where the variances of its points' offsets differ this much.
constexpr double doubled_spread = 2;
constexpr double least_doubled = 12;
constexpr int most_rounds = 3;
// Curves may be joined wrongly where they pass within so many standard deviations, or
// D.
constexpr double doubt_noise = 2;
constexpr double doubt_unit = 0.6;
constexpr double least_gain = 1; // of the score, by which another topology is better
// Noise of one length is tried where the noise is that much wider than the least, with
// a width of this share of its length. The peakedness is 2 for normal noise.
constexpr double least_shell = 1.2;
constexpr double shell_width = 0.2;
constexpr double most_peakedness = 2.2;
constexpr std::size_t least_rest = 8;

// A part this large is looked at before it is worked on: where hardly any neighbourhood
// of sampled points is linear, it is a surface or a volume.
constexpr std::size_t large_part = 5000;
constexpr std::size_t looked_at = 200;
constexpr std::size_t least_thinned = 1000;
constexpr double least_linearity = 0.3;

/** \brief Whether most of some neighbourhoods of 2 or 4 times \a size are linear. */
bool
looksLinear(const Points& points, const UniformGrid& grid, double size)
{
  std::vector<double> best;
  const std::size_t stride = points.size() / looked_at;
  for (std::size_t i = 0; i < points.size(); i += stride) {
    double linearity = 0;
    for (const double radius : {2 * size, 4 * size}) {
      Point first = Point::Zero();
      Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
      double count = 0;
      grid.forEachWithin(points[i], radius, [&](Index k, double) {
        const Point v = points[k] - points[i];
        first += v;
        second += v * v.transpose();
        count += 1;
      });
      first /= count;
      linearity =
          std::max(linearity, linearityOf(second / count - first * first.transpose()));
    }
    best.push_back(linearity);
  }
  const auto middle = best.begin() + static_cast<std::ptrdiff_t>(best.size() / 2);
  std::nth_element(best.begin(), middle, best.end());
  return *middle >= least_linearity;
}

/** \brief Whether \a start leads to the fit \a best, or to one like it: as many curves
 * of the same length and ends, nowhere farther from it than \a tolerance. */
bool
leadsTo(const EmFit& best, const ModelCurves& start, double tolerance)
{
  if (start.size() != best.curves.size())
    return false;
  const auto rings = [](const ModelCurves& curves) {
    return std::count_if(curves.begin(), curves.end(), [](const ModelCurve& curve) {
      return curve.closed;
    });
  };
  if (rings(start) != rings(best.curves) ||
      std::abs(length(start) - length(best.curves)) > 0.1 * length(best.curves))
    return false;
  Points nodes;
  for (const ModelCurve& curve : best.curves)
    for (const Point& node : resampled(curve, 0.5 * tolerance).nodes)
      nodes.push_back(node);
  const UniformGrid grid(nodes, tolerance);
  for (const ModelCurve& curve : start)
    for (const Point& node : curve.nodes)
      if (grid.nearest(node, tolerance) == UniformGrid::none)
        return false;
  return true;
}

/** \brief \a fit with every curve doubled whose points lie to two sides of it.
 *
 * That is told by the spread of their offsets: far wider in one direction than in the
 * other. \return nothing if there is no such curve */
ModelCurves
doubled(const EmFit& fit, const Points& points, const UniformGrid& grid, double reach)
{
  ModelCurves result;
  bool any = false;
  for (const ModelCurve& curve : fit.curves) {
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    double count = 0;
    for (std::size_t e = 0; e < curve.edges(); ++e) {
      const Point chord = curve.to(e) - curve.from(e);
      const double edge_length = chord.norm();
      const Point direction = chord / std::max(edge_length, 1e-300);
      const Point middle = 0.5 * (curve.from(e) + curve.to(e));
      grid.forEachWithin(middle, reach + edge_length, [&](Index i, double) {
        const Point v = points[i] - middle;
        const double z = v.dot(direction);
        const Point off = v - z * direction;
        if (std::abs(z) > 0.5 * edge_length || off.squaredNorm() > reach * reach)
          return;
        spread += off * off.transpose();
        count += 1;
      });
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(spread);
    const Point values = eigen.eigenvalues();
    if (count < least_doubled || values.z() < doubled_spread * values.y()) {
      result.push_back(curve);
      continue;
    }
    any = true;
    const Point shift = std::sqrt(values.z() / count) * eigen.eigenvectors().col(2);
    for (const double side : {-1.0, 1.0}) {
      result.push_back(curve);
      for (Point& node : result.back().nodes)
        node += side * shift;
    }
  }
  return any ? result : ModelCurves();
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
  fit(const ModelCurves& start, const EmSettings& settings)
  {
    return fitter_.fit(start, settings);
  }

  /** \brief Lets bandwidth, spacing and noise vary by \a scales from here on. */
  void
  vary(const ScaleField* scales)
  {
    scales_ = scales;
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
    const bool alike = best_.settings.scales == scales_;
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
    EmFit fit = fitter_.fit(start, settings);
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
      if (part.take(part.fit(start, settings), part.best().settings, least_gain))
        better = true;
    }
  return better;
}

/** \brief Fits noise of one length where the distances of the points may be such. */
void
fitShell(Part& part)
{
  const EmFit& best = part.best().fit;
  EmSettings settings = part.best().settings;
  if (best.curves.empty() || settings.scales || part.dimensions() < 3 ||
      best.noise < least_shell * settings.least_noise ||
      best.peakedness > most_peakedness)
    return;
  settings.shell = std::sqrt(3.0) * best.noise;
  settings.noise = shell_width * settings.shell;
  part.take(part.fit(best.curves, settings), settings);
}

/** \brief Fits a share of the points, so few that their spacing is about \a size times
 * as wide. */
EmFit
refineThinned(const Points& points,
              double size,
              const RefinedSettings& user,
              const std::function<bool()>& stop,
              const std::function<void(double)>& progress)
{
  const double share =
      std::max(1 / (size * size * size),
               static_cast<double>(least_thinned) / static_cast<double>(points.size()));
  boost::random::mt19937 random(1);
  boost::random::uniform_01<double> uniform;
  Points some;
  for (const Point& p : points)
    if (uniform(random) < share)
      some.push_back(p);
  EmFit fit = refinePart(some, user, nullptr, stop, progress);
  for (auto& counts : fit.counts)
    for (double& count : counts)
      count /= share;
  return fit;
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
    part.vary(scales);
    for (const std::size_t k : varied_bandwidths)
      part.tryBandwidth(k);
  }
  // Close parallel curves are traced as one.
  EmFit& best = part.best().fit;
  const ModelCurves pairs = doubled(best, points, part.grid(), 4 * best.noise);
  if (!pairs.empty()) {
    EmSettings settings = part.best().settings;
    settings.noise = 0.6 * best.noise;
    part.take(part.fit(pairs, settings), part.best().settings);
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
  fitShell(part);
  return std::move(best);
}

std::vector<Indices>
connectedParts(const Points& points,
               double distance,
               std::size_t least,
               const ScaleField* scales)
{
  const UniformGrid grid(points, distance);
  std::vector<std::size_t> root(points.size());
  std::iota(root.begin(), root.end(), std::size_t(0));
  const auto rootOf = [&](std::size_t i) {
    while (root[i] != i)
      i = root[i] = root[root[i]];
    return i;
  };
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double wider = scales ? std::max(1.0, scales->at(points[i])) : 1;
    grid.forEachWithin(points[i], wider * distance, [&](Index j, double) {
      const std::size_t a = rootOf(i), b = rootOf(j);
      root[std::max(a, b)] = std::min(a, b);
    });
  }
  std::vector<Indices> all(points.size()), parts;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points[i].allFinite())
      all[rootOf(i)].push_back(static_cast<Index>(i));
  for (Indices& members : all)
    if (members.size() >= least)
      parts.push_back(std::move(members));
  return parts;
}

} // namespace linelet
