// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "junction_bridging.h"

#include <algorithm>
#include <cmath>

namespace linelet {

namespace {

constexpr double widest_share = 0.15;
constexpr double wide_angle = 35 * M_PI / 180;
// Ends that turn farther from each other are joined by a straight bridge.
constexpr double facing_angle = 60 * M_PI / 180;
// Beyond so many ends every pair is not looked at any more.
constexpr std::size_t most_ends = 4000;

struct Bridge {
  double cost;
  std::size_t a, b; // curve * 2 + end
  double bend;      // 1: in the directions of the ends, 0: straight
};

Point
tip(const ModelCurve& curve, std::size_t end)
{
  return end == 0 ? curve.nodes.front() : curve.nodes.back();
}

/** \brief Nodes of the cubic from the tip a, leaving along da, to the tip b, whose own
 * curve leaves it along db. */
Points
cubic(const Point& a, const Point& da, const Point& b, const Point& db, double spacing)
{
  const double gap = (b - a).norm();
  const auto parts = static_cast<std::size_t>(std::ceil(gap / spacing));
  Points result;
  for (std::size_t k = 1; k < parts; ++k) {
    const double t = static_cast<double>(k) / static_cast<double>(parts);
    const double s = 1 - t;
    result.push_back((1 + 2 * t) * s * s * a + t * s * s * gap * da +
                     t * t * (3 - 2 * t) * b + t * t * s * gap * db);
  }
  return result;
}

/** \brief One round over all ends, by the lengths before it.
 * \return \a result is changed where this is true */
bool
bridgeOnce(
    ModelCurves& result, double near, double widest, double reach, double near_angle)
{
  std::vector<double> lengths;
  std::vector<std::size_t> ends;
  for (std::size_t c = 0; c < result.size(); ++c) {
    lengths.push_back(length(result[c]));
    for (std::size_t end = 0; end < 2; ++end)
      if (!result[c].closed && result[c].junction[end] < 0 && result[c].edges() > 0)
        ends.push_back(2 * c + end);
  }
  if (ends.size() > most_ends)
    return false;
  std::vector<Point> tips, directions;
  for (const std::size_t e : ends) {
    tips.push_back(tip(result[e / 2], e % 2));
    directions.push_back(
        outwardDirection(result[e / 2], static_cast<int>(e % 2), reach));
  }
  std::vector<Bridge> bridges;
  for (std::size_t i = 0; i < ends.size(); ++i)
    for (std::size_t j = i + 1; j < ends.size(); ++j) {
      const Point gap = tips[j] - tips[i];
      const double width = gap.norm();
      const std::size_t a = ends[i] / 2, b = ends[j] / 2;
      const double both = width + lengths[a] + (a == b ? 0 : lengths[b]);
      const bool is_near = width <= near && (a != b || lengths[a] > 5 * near);
      if ((widest > 0 && width > widest) || (!is_near && width > widest_share * both))
        continue;
      double angles = 0, worst = 0;
      if (width > 0)
        for (const double cosine :
             {directions[i].dot(gap) / width, -directions[j].dot(gap) / width}) {
          const double angle = std::acos(std::clamp(cosine, -1.0, 1.0));
          angles += angle;
          worst = std::max(worst, angle);
        }
      if (worst <= (is_near ? near_angle : wide_angle))
        bridges.push_back({width * (1 + angles),
                           ends[i],
                           ends[j],
                           worst <= facing_angle ? 1.0 : 0.0});
    }
  std::sort(bridges.begin(), bridges.end(), [](const Bridge& p, const Bridge& q) {
    return p.cost != q.cost ? p.cost < q.cost : p.a != q.a ? p.a < q.a : p.b < q.b;
  });

  // Where each original end is now: ends of joined curves move to the joint curve.
  std::vector<std::size_t> now(2 * result.size());
  for (std::size_t e = 0; e < now.size(); ++e)
    now[e] = e;
  constexpr auto used = static_cast<std::size_t>(-1);
  for (const Bridge& bridge : bridges) {
    const std::size_t a = now[bridge.a], b = now[bridge.b];
    if (a == used || b == used)
      continue;
    ModelCurve& first = result[a / 2];
    const ModelCurve second = result[b / 2];
    const double spacing = length(first) / static_cast<double>(first.edges());
    const Points between =
        cubic(tip(first, a % 2),
              bridge.bend * outwardDirection(first, static_cast<int>(a % 2), reach),
              tip(second, b % 2),
              bridge.bend * outwardDirection(second, static_cast<int>(b % 2), reach),
              spacing);
    now[bridge.a] = now[bridge.b] = used;
    const bool counted = !first.counts.empty() && !second.counts.empty();
    // The bridge explains no points.
    const std::vector<double> none(between.size() + 1, 0);
    if (a / 2 == b / 2) {
      if (a % 2 == 1)
        first.nodes.insert(first.nodes.end(), between.begin(), between.end());
      else
        first.nodes.insert(first.nodes.end(), between.rbegin(), between.rend());
      if (counted)
        first.counts.insert(first.counts.end(), none.begin(), none.end());
      first.closed = true;
      continue;
    }
    // The far ends keep their names: first's at 0, second's at 1.
    if (a % 2 == 0) {
      std::reverse(first.nodes.begin(), first.nodes.end());
      std::reverse(first.counts.begin(), first.counts.end());
    }
    if (!counted)
      first.counts.clear();
    first.nodes.insert(first.nodes.end(), between.begin(), between.end());
    if (b % 2 == 0)
      first.nodes.insert(first.nodes.end(), second.nodes.begin(), second.nodes.end());
    else
      first.nodes.insert(first.nodes.end(), second.nodes.rbegin(), second.nodes.rend());
    if (counted) {
      std::vector<double>& counts = first.counts;
      counts.insert(counts.end(), none.begin(), none.end());
      if (b % 2 == 0)
        counts.insert(counts.end(), second.counts.begin(), second.counts.end());
      else
        counts.insert(counts.end(), second.counts.rbegin(), second.counts.rend());
    }
    const int outer[2] = {a % 2 == 0 ? first.junction[1] : first.junction[0],
                          second.junction[1 - b % 2]};
    first.junction = {outer[0], outer[1]};
    const std::size_t far_first = a ^ 1, far_second = b ^ 1;
    for (std::size_t& e : now) {
      if (e == far_first && e != used)
        e = 2 * (a / 2);
      else if (e == far_second && e != used)
        e = 2 * (a / 2) + 1;
    }
    result[b / 2].nodes.clear();
  }
  result.erase(
      std::remove_if(result.begin(),
                     result.end(),
                     [](const ModelCurve& curve) { return curve.nodes.empty(); }),
      result.end());
  return !bridges.empty();
}

} // namespace

ModelCurves
bridgeGaps(const ModelCurves& curves,
           double near,
           double widest,
           double reach,
           double near_angle)
{
  // What has grown longer reaches farther.
  ModelCurves result = curves;
  while (bridgeOnce(result, near, widest, reach, near_angle)) {
  }
  return result;
}

} // namespace linelet
