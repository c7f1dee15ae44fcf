// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "revision.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <linelet/search/uniform_grid.h>

#include "bridging.h"
#include "pairing.h"

namespace linelet {

namespace {

constexpr double least_cosine = 0.5; // of the sharpest bend that is not doubtful
// Two stretches of one curve pass each other if the arc between them is this many times
// the gap.
constexpr double least_arc = 5;
// In sizes: the gap that is bridged whatever the length, and the stretch that gives the
// direction of an arm.
constexpr double near_gap = 3;
constexpr double arm_reach = 3;

/** \brief The nodes of all curves, one after another. */
struct AllNodes {
  Points at;
  std::vector<std::size_t> curve;
  std::vector<double> arc; // from the front of its curve
};

AllNodes
allNodes(const ModelCurves& curves)
{
  AllNodes result;
  for (std::size_t c = 0; c < curves.size(); ++c) {
    const Points& nodes = curves[c].nodes;
    double walked = 0;
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      if (k > 0)
        walked += (nodes[k] - nodes[k - 1]).norm();
      result.at.push_back(nodes[k]);
      result.curve.push_back(c);
      result.arc.push_back(walked);
    }
  }
  return result;
}

/** \brief The nearest node of another stretch. */
struct Passing {
  double gap = std::numeric_limits<double>::infinity(); // squared; none: infinity
  Point other = Point::Zero();
};

/** \brief For each node, what passes it within \a distance. */
std::vector<Passing>
passingStretches(const ModelCurves& curves, double distance)
{
  const AllNodes nodes = allNodes(curves);
  std::vector<double> lengths;
  for (const ModelCurve& curve : curves)
    lengths.push_back(length(curve));
  const auto is_one_stretch = [&](std::size_t i, std::size_t j) {
    const std::size_t c = nodes.curve[i];
    if (nodes.curve[j] != c)
      return false;
    const double between = std::abs(nodes.arc[i] - nodes.arc[j]);
    return (curves[c].closed ? std::min(between, lengths[c] - between) : between) <
           least_arc * distance;
  };
  std::vector<Passing> result(nodes.at.size());
  const UniformGrid grid(nodes.at, distance);
  for (std::size_t i = 0; i < result.size(); ++i)
    grid.forEachWithin(nodes.at[i], distance, [&](Index j, double squared) {
      if (squared < result[i].gap && !is_one_stretch(i, j))
        result[i] = {squared, nodes.at[j]};
    });
  return result;
}

/** \brief A node of a curve with \a width nodes on either side. */
struct Window {
  const ModelCurve& curve;
  std::size_t node, width;

  bool
  isRound() const
  {
    return curve.closed && curve.nodes.size() > 2 * width;
  }
  bool
  hasBefore(std::size_t steps) const
  {
    return isRound() || node >= steps;
  }
  bool
  hasAfter(std::size_t steps) const
  {
    return isRound() || node + steps < curve.nodes.size();
  }
  std::size_t
  before(std::size_t steps) const
  {
    return (node + curve.nodes.size() - steps) % curve.nodes.size();
  }
  std::size_t
  after(std::size_t steps) const
  {
    return (node + steps) % curve.nodes.size();
  }
};

/** \brief Number of nodes over \a distance. */
std::size_t
nodesOver(double distance, const ModelCurve& curve)
{
  const double spacing =
      curve.edges() > 0 ? length(curve) / static_cast<double>(curve.edges()) : 0;
  return static_cast<std::size_t>(
      std::clamp(std::round(distance / std::max(spacing, 1e-300)), 1.0, 20.0));
}

/** \brief Whether another stretch comes closest here; in a tie, at the first node.
 * \param[in] passing of the nodes of the curve */
bool
isNarrowest(const Passing* passing, const Window& window)
{
  const double gap = passing[window.node].gap;
  if (!std::isfinite(gap))
    return false;
  for (std::size_t w = 1; w <= window.width; ++w)
    if ((window.hasAfter(w) && gap > passing[window.after(w)].gap) ||
        (window.hasBefore(w) && gap >= passing[window.before(w)].gap))
      return false;
  return true;
}

bool
isBend(const Window& window)
{
  const std::size_t w = window.width;
  if (!window.hasBefore(w) || !window.hasAfter(w))
    return false;
  const Points& nodes = window.curve.nodes;
  const Point before = nodes[window.node] - nodes[window.before(w)];
  const Point after = nodes[window.after(w)] - nodes[window.node];
  return before.dot(after) < least_cosine * before.norm() * after.norm();
}

} // namespace

Points
doubtfulPlaces(const ModelCurves& curves, double distance)
{
  const std::vector<Passing> passing = passingStretches(curves, distance);
  Points result;
  std::size_t first = 0;
  for (const ModelCurve& curve : curves) {
    const std::size_t width = nodesOver(distance, curve);
    const Passing* const here = passing.data() + first;
    for (std::size_t k = 0; k < curve.nodes.size(); ++k) {
      const Window window{curve, k, width};
      if (isNarrowest(here, window))
        result.push_back(0.5 * (curve.nodes[k] + here[k].other));
      else if (isBend(window))
        result.push_back(curve.nodes[k]);
    }
    if (!curve.closed && !curve.nodes.empty()) {
      if (curve.junction[0] >= 0)
        result.push_back(curve.nodes.front());
      if (curve.junction[1] >= 0)
        result.push_back(curve.nodes.back());
    }
    first += curve.nodes.size();
  }
  return result;
}

ModelCurves
cutAround(const ModelCurves& curves, const Points& places, double radius)
{
  ModelCurves result;
  const UniformGrid grid(places, radius);
  for (const ModelCurve& curve : curves) {
    const std::size_t n = curve.nodes.size();
    std::vector<char> inside(n, 0);
    bool any = false;
    std::size_t start = 0;
    for (std::size_t k = 0; k < n; ++k) {
      grid.forEachWithin(curve.nodes[k], radius, [&](Index, double) { inside[k] = 1; });
      if (inside[k] && !any)
        start = k;
      any = any || inside[k];
    }
    if (!any) {
      result.push_back(curve);
      continue;
    }
    if (!curve.closed)
      start = 0;
    ModelCurve piece;
    piece.scale = curve.scale;
    for (std::size_t i = 0; i <= n; ++i) {
      const std::size_t k = (start + i) % n;
      if (i < n && !inside[k]) {
        piece.nodes.push_back(curve.nodes[k]);
        continue;
      }
      if (piece.nodes.size() > 1)
        result.push_back(piece);
      piece.nodes.clear();
    }
  }
  return result;
}

ModelCurves
rejoined(const ModelCurves& curves,
         const Points& places,
         double size,
         Rejoining rejoining)
{
  if (places.empty())
    return {};
  const double reach = arm_reach * size;
  ModelCurves result;
  if (rejoining == Rejoining::Paired) {
    PairingSettings pairing;
    pairing.cluster = size;
    pairing.cut = size;
    pairing.reach = reach;
    result = pairArms(curves, places, pairing);
  }
  else
    result = bridgeGaps(cutAround(curves, places, size), near_gap * size, 0, reach);
  for (ModelCurve& curve : result)
    curve.scale = size;
  return result;
}

} // namespace linelet
