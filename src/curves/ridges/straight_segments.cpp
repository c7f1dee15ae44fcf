// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "straight_segments.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include <Eigen/Eigenvalues>

namespace linelet {

namespace {

constexpr std::size_t proposals = 150; // pairs of points that are tried
constexpr std::size_t refined = 5;     // the best of them
constexpr int refinements = 3;
constexpr std::size_t most_segments = 16;
constexpr double tube = 3;             // standard deviations; points beyond say nothing
constexpr double curve_parameters = 4; // its share, its existence and its two ends

/** \brief A segment of a line. */
struct Interval {
  double begin, end;
};

/** \brief Segments of one line. */
struct Line {
  Point at = Point::Zero(), direction = Point::UnitX();
  std::vector<Interval> intervals;
  double density = 0; // points per length
  double gain = 0;    // of the logarithmic likelihood, less what the segments cost

  bool
  covers(double along) const
  {
    return std::any_of(intervals.begin(), intervals.end(), [&](const Interval& i) {
      return along >= i.begin && along <= i.end;
    });
  }
};

/** \brief The best segments of a line up to one of its points. */
struct Step {
  double begin;       ///< of the segment that is open here
  double open;        ///< best gain with a segment open at this point
  double shut;        ///< best gain with none
  bool ends;          ///< whether that one ends here
  std::size_t before; ///< number of points before the open segment
};

class StraightSearch {
public:
  StraightSearch(const Points& points, const SegmentSettings& settings)
      : points_(points),
        settings_(settings),
        intensity_(points.size(), settings.background)
  {
    const double variance = 2 * M_PI * settings.noise * settings.noise;
    peak_ = settings.dimensions == 3 ? 1 / variance : 1 / std::sqrt(variance);
    const double parameter = 0.5 * std::log(static_cast<double>(points.size()));
    segment_cost_ = curve_parameters * parameter;
    line_cost_ = 2 * (settings.dimensions - 1) * parameter;
  }

  std::optional<Line>
  next();
  void
  explain(const Line& line);

private:
  /** \brief Points per volume that \a line adds at \a point, if it is within the tube
   * around it, else 0; \a along: where along the line. */
  double
  intensityOf(const Line& line, const Point& point, double& along) const
  {
    const Point v = point - line.at;
    along = v.dot(line.direction);
    const double squared =
        (v.squaredNorm() - along * along) / (settings_.noise * settings_.noise);
    return squared < tube * tube ? line.density * peak_ * std::exp(-0.5 * squared) : 0;
  }
  void
  findIntervals(Line& line);
  bool
  refine(Line& line);

  const Points& points_;
  SegmentSettings settings_;
  double peak_; // of the noise, per area (length) across a line
  // Of a segment and, beside it, of a line, by the Bayesian information criterion.
  double segment_cost_, line_cost_;
  std::vector<double> intensity_;
  // Of the points near a line: where along it, and what each gains.
  std::vector<std::pair<double, double>> gains_;
  std::vector<Step> steps_; // at these points
};

/** \brief Sets the intervals of \a line that gain most, by dynamic programming. */
void
StraightSearch::findIntervals(Line& line)
{
  gains_.clear();
  for (std::size_t i = 0; i < points_.size(); ++i) {
    double along;
    const double added = intensityOf(line, points_[i], along);
    if (added > 0)
      gains_.emplace_back(along, std::log1p(added / intensity_[i]));
  }
  std::sort(gains_.begin(), gains_.end());
  std::vector<Step>& steps = steps_;
  steps.clear();
  for (std::size_t k = 0; k < gains_.size(); ++k) {
    const auto [place, gain] = gains_[k];
    const double shut = k == 0 ? 0 : steps[k - 1].shut;
    Step step{place, shut - segment_cost_ + gain, shut, false, k};
    if (k > 0) {
      const double gap = line.density * (place - gains_[k - 1].first);
      const double kept = steps[k - 1].open - gap + gain;
      if (kept > step.open) {
        step.open = kept;
        step.begin = steps[k - 1].begin;
        step.before = steps[k - 1].before;
      }
    }
    if (step.open > step.shut) {
      step.shut = step.open;
      step.ends = true;
    }
    steps.push_back(step);
  }
  line.gain = -line_cost_;
  line.intervals.clear();
  for (std::size_t k = steps.size(); k > 0;) {
    const std::size_t last = k - 1;
    const Step& end = steps[last];
    if (!end.ends) {
      --k;
      continue;
    }
    k = end.before;
    const double place = gains_[last].first;
    if (place - end.begin < settings_.least_length)
      continue;
    line.intervals.push_back({end.begin, place});
    line.gain += end.open - (k > 0 ? steps[k - 1].shut : 0);
  }
}

/** \brief Moves \a line amid the points that it explains.
 * \return whether it explains more than before */
bool
StraightSearch::refine(Line& line)
{
  Point first = Point::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  double weights = 0;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    double along;
    const double added = intensityOf(line, points_[i], along);
    if (added == 0 || !line.covers(along))
      continue;
    const double weight = added / (added + intensity_[i]);
    const Point v = points_[i] - line.at;
    first += weight * v;
    second += weight * v * v.transpose();
    weights += weight;
  }
  double length = 0;
  for (const Interval& interval : line.intervals)
    length += interval.end - interval.begin;
  if (!(length > 0))
    return false;
  first /= weights;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(second / weights -
                                                             first * first.transpose());
  Line moved;
  moved.at = line.at + first;
  moved.direction = eigen.eigenvectors().col(2);
  moved.density = weights / length;
  findIntervals(moved);
  if (!(moved.gain > line.gain))
    return false;
  line = moved;
  return true;
}

std::optional<Line>
StraightSearch::next()
{
  Indices free;
  for (std::size_t i = 0; i < points_.size(); ++i)
    if (intensity_[i] < 2 * settings_.background)
      free.push_back(static_cast<Index>(i));
  if (free.size() < 2)
    return {};
  std::vector<Line> tried;
  std::uint64_t random = 1; // a linear congruential generator
  const auto draw = [&] {
    random = random * 6364136223846793005u + 1442695040888963407u;
    return static_cast<std::size_t>((random >> 33) % free.size());
  };
  for (std::size_t k = 0; k < proposals; ++k) {
    const Point& a = points_[free[draw()]];
    const Point& b = points_[free[draw()]];
    if ((b - a).norm() < settings_.least_length)
      continue;
    Line line;
    line.at = a;
    line.direction = (b - a).normalized();
    line.density = settings_.density;
    findIntervals(line);
    tried.push_back(std::move(line));
  }
  const std::size_t best = std::min(refined, tried.size());
  std::partial_sort(tried.begin(),
                    tried.begin() + static_cast<std::ptrdiff_t>(best),
                    tried.end(),
                    [](const Line& s, const Line& t) { return s.gain > t.gain; });
  std::optional<Line> result;
  for (std::size_t k = 0; k < best; ++k) {
    Line& line = tried[k];
    for (int step = 0; step < refinements && refine(line); ++step) {
    }
    if (line.gain > (result ? result->gain : 0))
      result = line;
  }
  return result;
}

void
StraightSearch::explain(const Line& line)
{
  for (std::size_t i = 0; i < points_.size(); ++i) {
    double along;
    const double added = intensityOf(line, points_[i], along);
    if (added > 0 && line.covers(along))
      intensity_[i] += added;
  }
}

} // namespace

ModelCurves
straightSegments(const Points& points, const SegmentSettings& settings)
{
  ModelCurves curves;
  StraightSearch search(points, settings);
  while (curves.size() < most_segments) {
    const auto line = search.next();
    if (!line)
      break;
    search.explain(*line);
    for (const Interval& interval : line->intervals) {
      ModelCurve curve;
      for (const double along : {interval.begin, interval.end})
        curve.nodes.emplace_back(line->at + along * line->direction);
      curves.push_back(std::move(curve));
    }
  }
  return curves;
}

} // namespace linelet
