// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "hidden_stretches.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <tuple>

#include <Eigen/Cholesky>

#include <linelet/search/uniform_grid.h>

#include "curves/network/curve_joining.h"

namespace linelet {

namespace {

constexpr std::size_t least_nodes = 4; // of a curve, to determine a parabola
// Cosine of the angle by which a curve may turn away from the gap before it.
constexpr double facing = 0.9;

/** \brief An end of a curve, and what comes before it. */
struct End {
  std::size_t curve, side; ///< side 0: the front
  Point tip, direction;    ///< out of the curve
  double length;           ///< of the curve
  double spacing;          ///< of its points
};

/** \brief Points per length of \a curve. */
double
densityOf(const ModelCurve& curve)
{
  return std::accumulate(curve.counts.begin(), curve.counts.end(), 0.0) / length(curve);
}

/** \brief Open ends of \a curves that are seen well enough. */
std::vector<End>
endsOf(const ModelCurves& curves)
{
  std::vector<End> ends;
  for (std::size_t c = 0; c < curves.size(); ++c) {
    const ModelCurve& curve = curves[c];
    if (curve.closed || curve.nodes.size() < least_nodes)
      continue;
    const double own = length(curve), density = densityOf(curve);
    if (!(own > 0) || !(density > 0))
      continue;
    for (std::size_t side = 0; side < 2; ++side)
      ends.push_back({c,
                      side,
                      side == 0 ? curve.nodes.front() : curve.nodes.back(),
                      outwardDirection(curve,
                                       static_cast<int>(side),
                                       3 * own / static_cast<double>(curve.edges())),
                      own,
                      1 / density});
  }
  return ends;
}

/** \brief Nodes of \a curve from its end on \a side, over \a reach, at least
 * \ref least_nodes. */
Points
nodesBefore(const ModelCurve& curve, std::size_t side, double reach)
{
  Points result;
  double walked = 0;
  for (std::size_t k = 0; k < curve.nodes.size(); ++k) {
    const Point& node = curve.nodes[side == 0 ? k : curve.nodes.size() - 1 - k];
    if (!result.empty())
      walked += (node - result.back()).norm();
    if (walked > reach && result.size() >= least_nodes)
      break;
    result.push_back(node);
  }
  return result;
}

/** \brief A parabola over a straight line from \ref origin along \ref axis. */
struct Parabola {
  Point origin, axis;
  Eigen::Matrix3d coefficients; ///< columns: constant, linear, quadratic, over a scale
  double scale = 1;
  double deviation = 0; ///< of the points from it, per coordinate across

  Point
  at(double place) const
  {
    const double t = place / scale;
    return origin + place * axis + coefficients * Point(1, t, t * t);
  }
  double
  placeOf(const Point& p) const
  {
    return axis.dot(p - origin);
  }
};

/** \brief The parabola through \a a and \a b, in the middle of which their gap is. */
Parabola
parabolaThrough(const Points& a, const Points& b)
{
  Parabola result;
  result.origin = 0.5 * (a.front() + b.front());
  result.axis = (b.back() - a.back()).stableNormalized();
  result.scale = 0.5 * (b.back() - a.back()).norm();
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero(), right = Eigen::Matrix3d::Zero();
  const auto rowOf = [&](const Point& p) {
    const double t = result.placeOf(p) / result.scale;
    return Point(1, t, t * t);
  };
  const auto across = [&](const Point& p) {
    return Point(p - result.origin - result.placeOf(p) * result.axis);
  };
  for (const Points* side : {&a, &b})
    for (const Point& p : *side) {
      normal += rowOf(p) * rowOf(p).transpose();
      right += across(p) * rowOf(p).transpose();
    }
  result.coefficients = normal.ldlt().solve(right.transpose()).transpose();
  double squares = 0;
  for (const Points* side : {&a, &b})
    for (const Point& p : *side)
      squares += (across(p) - result.coefficients * rowOf(p)).squaredNorm();
  const double freedom = 2 * (static_cast<double>(a.size() + b.size()) - 3);
  result.deviation = std::sqrt(squares / freedom);
  return result;
}

struct Join {
  double gap;
  std::size_t a, b; ///< ends
};

/** \brief Whether one parabola runs through both curves. */
bool
agree(const ModelCurves& curves, const End& a, const End& b, double gap)
{
  const Points before = nodesBefore(curves[a.curve], a.side, gap);
  const Points behind = nodesBefore(curves[b.curve], b.side, gap);
  const Parabola both = parabolaThrough(before, behind);
  return both.deviation <= std::min(curves[a.curve].noise, curves[b.curve].noise);
}

/** \brief What may be joined, the narrowest gaps first. */
std::vector<Join>
possibleJoins(const ModelCurves& curves,
              const std::vector<End>& ends,
              double widest,
              double cutoff)
{
  std::vector<Join> joins;
  if (ends.empty())
    return joins;
  Points tips;
  std::vector<double> reach;
  for (const End& end : ends) {
    tips.push_back(end.tip);
    reach.push_back(std::min({end.length, widest * end.spacing, cutoff}));
  }
  const UniformGrid grid(tips, *std::max_element(reach.begin(), reach.end()));
  for (std::size_t i = 0; i < ends.size(); ++i)
    grid.forEachWithin(ends[i].tip, reach[i], [&](std::size_t j, double squared) {
      const End &a = ends[i], &b = ends[j];
      const double gap = std::sqrt(squared);
      const bool is_longer = std::tie(a.length, i) > std::tie(b.length, j);
      if (!is_longer || a.curve == b.curve || gap > 0.5 * (a.length + b.length))
        return;
      const Point way = b.tip - a.tip;
      if (a.direction.dot(way) < facing * gap || b.direction.dot(way) > -facing * gap)
        return;
      if (agree(curves, a, b, gap))
        joins.push_back({gap, i, j});
    });
  std::sort(joins.begin(), joins.end(), [](const Join& p, const Join& q) {
    return std::tie(p.gap, p.a, p.b) < std::tie(q.gap, q.a, q.b);
  });
  return joins;
}

/** \brief Lengthens the curve of \a a by the hidden stretch and the curve of \a b,
 * which is left empty. */
void
join(ModelCurves& curves, const End& a, const End& b, double gap)
{
  ModelCurve &first = curves[a.curve], &second = curves[b.curve];
  const Points before = nodesBefore(first, a.side, gap);
  const Points behind = nodesBefore(second, b.side, gap);
  const Parabola both = parabolaThrough(before, behind);
  if (a.side == 0)
    turnRound(first);
  if (b.side == 1)
    turnRound(second);
  const double spacing = length(first) / static_cast<double>(first.edges());
  const double from = both.placeOf(a.tip), to = both.placeOf(b.tip);
  const Point at_a = a.tip - both.at(from), at_b = b.tip - both.at(to);
  const auto parts = static_cast<std::size_t>(std::max(1.0, std::ceil(gap / spacing)));
  Points hidden;
  for (std::size_t k = 1; k < parts; ++k) {
    const double t = static_cast<double>(k) / static_cast<double>(parts);
    hidden.push_back(both.at(from + t * (to - from)) + (1 - t) * at_a + t * at_b);
  }
  appendCurve(first, hidden, second);
  second.nodes.clear();
}

} // namespace

ModelCurves
joinHiddenStretches(ModelCurves curves, double widest, double cutoff)
{
  for (bool joined = true; joined;) {
    joined = false;
    const std::vector<End> ends = endsOf(curves);
    std::vector<char> changed(curves.size(), 0);
    for (const Join& next : possibleJoins(curves, ends, widest, cutoff)) {
      const End &a = ends[next.a], &b = ends[next.b];
      if (changed[a.curve] != 0 || changed[b.curve] != 0)
        continue;
      join(curves, a, b, next.gap);
      changed[a.curve] = changed[b.curve] = 1;
      joined = true;
    }
    curves.erase(std::remove_if(curves.begin(),
                                curves.end(),
                                [](const ModelCurve& c) { return c.nodes.empty(); }),
                 curves.end());
  }
  return curves;
}

} // namespace linelet
