// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <bench/measures/measures.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include <bench/measures/segment_tree.h>

namespace linelet::bench {

namespace {

constexpr double most_samples = 2e6; // of a network

/** \brief Sum, number and maximum of the distances from samples to a curve network. */
struct Directed {
  double sum = 0, squared_max = 0;
  std::size_t count = 0;
};

/** \brief Distances from samples of \a curves, \a step apart, to \a target. */
Directed
distances(const CurveNetwork& curves, const SegmentTree& target, double step)
{
  Directed result;
  std::size_t hint = SegmentTree::none;
  const auto add = [&](const Point& sample) {
    const SegmentTree::Nearest found = target.nearest(sample, hint);
    hint = found.segment;
    result.sum += std::sqrt(found.squared_distance);
    result.squared_max = std::max(result.squared_max, found.squared_distance);
    ++result.count;
  };
  for (const Curve& curve : curves.curves) {
    const std::size_t vertices = curve.points.size();
    if (vertices == 0)
      continue;
    const double total = length(curve);
    const auto pieces = static_cast<std::size_t>(std::ceil(total / step));
    const double spacing =
        total / static_cast<double>(std::max<std::size_t>(pieces, 1));
    std::size_t next = 0; // sample to place
    double passed = 0;    // length before edge i
    for (std::size_t i = 0; vertices > 1 && i + (curve.closed ? 0 : 1) < vertices;
         ++i) {
      const Point& a = curve.points[i];
      const Point& b = curve.points[(i + 1) % vertices];
      const double edge = (b - a).norm();
      for (; next < pieces && static_cast<double>(next) * spacing < passed + edge;
           ++next)
        add(a + (b - a) * ((static_cast<double>(next) * spacing - passed) / edge));
      passed += edge;
    }
    if (!curve.closed || pieces == 0)
      add(curve.points.back());
  }
  return result;
}

/** \brief Length of the union of intervals. */
double
unionLength(std::vector<std::pair<double, double>>& intervals)
{
  std::sort(intervals.begin(), intervals.end());
  double sum = 0, end = -std::numeric_limits<double>::infinity();
  for (const auto& [from, to] : intervals) {
    if (to > end)
      sum += to - std::max(from, end);
    end = std::max(end, to);
  }
  return sum;
}

/** \brief The part of a true curve network covered by edges of another network. */
class Coverage {
public:
  /** \param[in] tree of \a truth; both must outlive this
   * \param[in] reach vertices farther from the truth cover nothing */
  Coverage(const CurveNetwork& truth, const SegmentTree& tree, double reach)
      : truth_(truth), tree_(tree), reach_(reach), covered_(truth.curves.size())
  {
    for (const Curve& curve : truth.curves)
      lengths_.push_back(length(curve));
  }

  /** \brief Covers the arcs onto which the edges of \a curve project. */
  void
  add(const Curve& curve)
  {
    const std::size_t vertices = curve.points.size();
    if (vertices < 2)
      return;
    Foot last = project(curve.points[0]);
    for (std::size_t i = 1; i < vertices + (curve.closed ? 1 : 0); ++i) {
      const Foot foot = project(curve.points[i % vertices]);
      coverBetween(last, foot);
      last = foot;
    }
  }

  /** \brief Length of the covered part of the truth. */
  double
  coveredLength()
  {
    double sum = 0;
    for (auto& intervals : covered_)
      sum += unionLength(intervals);
    return sum;
  }

private:
  /** \brief A vertex and its projection on the truth. */
  struct Foot {
    Point vertex;
    std::size_t curve = SegmentTree::none; // none: out of reach
    double arc = 0, distance = 0;
  };

  Foot
  footAt(const Point& vertex, const SegmentTree::Nearest& found) const
  {
    const double distance = std::sqrt(found.squared_distance);
    if (!(distance <= reach_))
      return {vertex};
    const SegmentTree::Segment& s = tree_.segments()[found.segment];
    return {vertex, s.curve, s.arc + found.parameter * (s.b - s.a).norm(), distance};
  }

  Foot
  project(const Point& vertex)
  {
    const SegmentTree::Nearest found = tree_.nearest(vertex, hint_);
    hint_ = found.segment;
    return footAt(vertex, found);
  }

  /** \brief \a foot on the curve of \a other, if that is as near: where curves of the
   * truth meet, a vertex is equally near to several of them. */
  Foot
  onCurveOf(const Foot& foot, const Foot& other) const
  {
    const Foot moved = footAt(foot.vertex, tree_.nearestOn(other.curve, foot.vertex));
    return moved.curve != SegmentTree::none && moved.distance < foot.distance + 1e-9
               ? moved
               : foot;
  }

  void
  coverBetween(Foot from, Foot to)
  {
    if (from.curve == SegmentTree::none || to.curve == SegmentTree::none)
      return;
    if (from.curve != to.curve)
      to = onCurveOf(to, from);
    if (from.curve != to.curve)
      from = onCurveOf(from, to);
    if (from.curve == to.curve)
      cover(from.curve, from.arc, to.arc);
  }

  /** \brief Covers the arc between two positions; on a closed curve, the shorter
   * one. */
  void
  cover(std::size_t curve, double begin, double end)
  {
    const auto [low, high] = std::minmax(begin, end);
    if (truth_.curves[curve].closed && high - low > lengths_[curve] / 2) {
      covered_[curve].emplace_back(0, low);
      covered_[curve].emplace_back(high, lengths_[curve]);
    }
    else
      covered_[curve].emplace_back(low, high);
  }

  const CurveNetwork& truth_;
  const SegmentTree& tree_;
  double reach_;
  std::vector<double> lengths_;                                 // of the true curves
  std::vector<std::vector<std::pair<double, double>>> covered_; // arcs of each of them
  std::size_t hint_ = SegmentTree::none;
};

void
check(const CurveNetwork& network, const char* which)
{
  for (const Curve& curve : network.curves)
    for (const Point& vertex : curve.points)
      if (!vertex.allFinite())
        throw std::invalid_argument(std::string("the ") + which +
                                    " has a vertex that is not finite");
}

} // namespace

Measures
measure(const CurveNetwork& reconstruction,
        const CurveNetwork& truth,
        const MeasureSettings& settings)
{
  check(reconstruction, "reconstruction");
  check(truth, "truth");
  if (!(settings.step > 0) || !(settings.reach >= 0))
    throw std::invalid_argument("step must be positive and reach must not be negative");
  const double true_length = length(truth), found_length = length(reconstruction);
  if (!(true_length > 0))
    throw std::invalid_argument("the truth holds no curve with a length");

  const SegmentTree truth_tree(truth), found_tree(reconstruction);
  Measures result;
  result.e_len = found_length / true_length;
  if (found_tree.segments().empty()) {
    result.e_h = result.e_v = std::numeric_limits<double>::quiet_NaN();
    return result;
  }
  const double step =
      std::max(settings.step, std::max(true_length, found_length) / most_samples);
  const Directed there = distances(truth, found_tree, step);
  const Directed back = distances(reconstruction, truth_tree, step);
  result.e_h = std::sqrt(std::max(there.squared_max, back.squared_max));
  result.e_v = (there.sum + back.sum) / static_cast<double>(there.count + back.count);
  Coverage coverage(truth, truth_tree, settings.reach);
  for (const Curve& curve : reconstruction.curves)
    coverage.add(curve);
  result.e_com = coverage.coveredLength() / true_length;
  result.success = result.e_len >= 0.9 && result.e_len <= 1.2 && result.e_com >= 0.95 &&
                   result.e_com <= 1.05 && result.e_v <= settings.max_mean_distance;
  return result;
}

} // namespace linelet::bench
