// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "bridging.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>

#include "curve_joining.h"

namespace linelet {

namespace {

constexpr double widest_share = 0.15;
constexpr double wide_angle = 35 * M_PI / 180;
// Ends that point off the gap by more than this are joined by a straight bridge.
constexpr double facing_angle = 60 * M_PI / 180;
// With more ends than this, not every pair is considered.
constexpr std::size_t most_ends = 4000;

// Ends are named 2 * curve + (0 front, 1 back).
constexpr auto joined = static_cast<std::size_t>(-1);

struct Limits {
  double near, widest, reach, near_angle; // as bridgeGaps has them
};

struct FreeEnd {
  std::size_t name;
  Point tip, direction;
  double length; // of its curve
};

struct Bridge {
  double cost;
  std::size_t a, b;
  double bend; // 1: in the directions of the ends, 0: straight
};

Point
tip(const ModelCurve& curve, std::size_t end)
{
  return end % 2 == 0 ? curve.nodes.front() : curve.nodes.back();
}

Point
outward(const ModelCurve& curve, std::size_t end, double reach)
{
  return outwardDirection(curve, static_cast<int>(end % 2), reach);
}

std::vector<FreeEnd>
freeEnds(const ModelCurves& curves, double reach)
{
  std::vector<FreeEnd> result;
  for (std::size_t c = 0; c < curves.size(); ++c) {
    const ModelCurve& curve = curves[c];
    if (curve.closed || curve.edges() == 0)
      continue;
    for (std::size_t end = 0; end < 2; ++end)
      if (curve.junction[end] < 0)
        result.push_back(
            {2 * c + end, tip(curve, end), outward(curve, end, reach), length(curve)});
  }
  return result;
}

/** \brief Angle between the unit vector \a direction and \a gap, which is \a width
 * long; 0 without a gap. */
double
angleOff(const Point& direction, const Point& gap, double width)
{
  return width > 0 ? std::acos(std::clamp(direction.dot(gap) / width, -1.0, 1.0)) : 0;
}

/** \brief The bridge between two ends, if they agree well enough. */
std::optional<Bridge>
bridgeBetween(const FreeEnd& a, const FreeEnd& b, const Limits& limits)
{
  const Point gap = b.tip - a.tip;
  const double width = gap.norm();
  const bool one_curve = a.name / 2 == b.name / 2;
  const double both = width + a.length + (one_curve ? 0 : b.length);
  const bool is_near =
      width <= limits.near && (!one_curve || a.length > 5 * limits.near);
  if ((limits.widest > 0 && width > limits.widest) ||
      (!is_near && width > widest_share * both))
    return {};
  const double at_a = angleOff(a.direction, gap, width);
  const double at_b = angleOff(b.direction, -gap, width);
  const double worst = std::max(at_a, at_b);
  if (worst > (is_near ? limits.near_angle : wide_angle))
    return {};
  return Bridge{
      width * (1 + (at_a + at_b)), a.name, b.name, worst <= facing_angle ? 1.0 : 0.0};
}

/** \brief All possible bridges, the best first. */
std::vector<Bridge>
possibleBridges(const std::vector<FreeEnd>& ends, const Limits& limits)
{
  std::vector<Bridge> result;
  for (std::size_t i = 0; i < ends.size(); ++i)
    for (std::size_t j = i + 1; j < ends.size(); ++j)
      if (const auto bridge = bridgeBetween(ends[i], ends[j], limits))
        result.push_back(*bridge);
  std::sort(result.begin(), result.end(), [](const Bridge& p, const Bridge& q) {
    return std::tie(p.cost, p.a, p.b) < std::tie(q.cost, q.a, q.b);
  });
  return result;
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

/** \brief Joins the ends \a a and \a b. If they belong to two curves, the curve of \a a
 * becomes the joined one, with its front at the end opposite to \a a, and the curve of
 * \a b becomes empty. */
void
join(ModelCurves& curves, std::size_t a, std::size_t b, double bend, double reach)
{
  ModelCurve& first = curves[a / 2];
  ModelCurve& second = curves[b / 2];
  const double spacing = length(first) / static_cast<double>(first.edges());
  Points bridge = cubic(tip(first, a),
                        bend * outward(first, a, reach),
                        tip(second, b),
                        bend * outward(second, b, reach),
                        spacing);
  if (a / 2 == b / 2) {
    if (a % 2 == 0)
      std::reverse(bridge.begin(), bridge.end());
    appendBridge(first, bridge);
    first.closed = true;
    return;
  }
  if (a % 2 == 0)
    turnRound(first);
  if (b % 2 == 1)
    turnRound(second);
  appendCurve(first, bridge, second);
  second.nodes.clear();
}

/** \brief One round over all ends, judged by the lengths before it.
 * \return whether \a curves was changed */
bool
bridgeOnce(ModelCurves& curves, const Limits& limits)
{
  const std::vector<FreeEnd> ends = freeEnds(curves, limits.reach);
  if (ends.size() > most_ends)
    return false;
  const std::vector<Bridge> bridges = possibleBridges(ends, limits);

  // The current name of each end: those of joined curves become ends of the whole.
  std::vector<std::size_t> now(2 * curves.size());
  std::iota(now.begin(), now.end(), std::size_t(0));
  for (const Bridge& bridge : bridges) {
    const std::size_t a = now[bridge.a], b = now[bridge.b];
    if (a == joined || b == joined)
      continue;
    join(curves, a, b, bridge.bend, limits.reach);
    now[bridge.a] = now[bridge.b] = joined;
    if (a / 2 != b / 2) {
      const std::size_t front = a / 2 * 2, back = front + 1;
      std::replace(now.begin(), now.end(), a ^ 1, front);
      std::replace(now.begin(), now.end(), b ^ 1, back);
    }
  }
  curves.erase(
      std::remove_if(curves.begin(),
                     curves.end(),
                     [](const ModelCurve& curve) { return curve.nodes.empty(); }),
      curves.end());
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
  // Curves that have become longer reach farther.
  ModelCurves result = curves;
  while (bridgeOnce(result, {near, widest, reach, near_angle})) {
  }
  return result;
}

} // namespace linelet
