// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "junction_revision.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <linelet/search/uniform_grid.h>

#include "junction_bridging.h"
#include "junction_pairing.h"

namespace linelet {

namespace {

constexpr double least_cosine = 0.5; // of a bend that is not doubted
// Stretches of one curve pass each other where the arc between them is this much
// longer than the gap.
constexpr double least_arc = 5;
// In sizes: the gap that is bridged whatever the length, and the stretch over which the
// direction of an arm is taken.
constexpr double near_gap = 3;
constexpr double arm_reach = 3;

} // namespace

Points
doubtfulPlaces(const ModelCurves& curves, double distance)
{
  Points nodes;
  std::vector<std::size_t> curve_of;
  std::vector<double> arc;
  std::vector<double> lengths;
  for (std::size_t c = 0; c < curves.size(); ++c) {
    double walked = 0;
    for (std::size_t k = 0; k < curves[c].nodes.size(); ++k) {
      if (k > 0)
        walked += (curves[c].nodes[k] - curves[c].nodes[k - 1]).norm();
      nodes.push_back(curves[c].nodes[k]);
      curve_of.push_back(c);
      arc.push_back(walked);
    }
    lengths.push_back(length(curves[c]));
  }
  Points result;
  if (nodes.empty())
    return result;
  const UniformGrid grid(nodes, distance);
  const double infinity = std::numeric_limits<double>::infinity();
  std::vector<double> gap(nodes.size(), infinity);
  std::vector<Index> other(nodes.size(), 0);
  for (std::size_t i = 0; i < nodes.size(); ++i)
    grid.forEachWithin(nodes[i], distance, [&](Index j, double squared) {
      if (squared >= gap[i])
        return;
      if (curve_of[i] == curve_of[j]) {
        double between = std::abs(arc[i] - arc[j]);
        if (curves[curve_of[i]].closed)
          between = std::min(between, lengths[curve_of[i]] - between);
        if (between < least_arc * distance)
          return;
      }
      gap[i] = squared;
      other[i] = j;
    });
  std::size_t first = 0;
  for (const ModelCurve& curve : curves) {
    const std::size_t n = curve.nodes.size();
    const double spacing =
        curve.edges() > 0 ? length(curve) / static_cast<double>(curve.edges()) : 0;
    const auto window = static_cast<std::size_t>(
        std::clamp(std::round(distance / std::max(spacing, 1e-300)), 1.0, 20.0));
    for (std::size_t k = 0; k < n; ++k) {
      const bool ring = curve.closed && n > 2 * window;
      bool least = gap[first + k] < infinity, bend = false;
      for (std::size_t w = 1; w <= window && least; ++w) {
        if (ring || k + w < n)
          least = least && gap[first + k] <= gap[first + (k + w) % n];
        if (ring || k >= w)
          least = least && gap[first + k] < gap[first + (k + n - w) % n];
      }
      if (ring || (k >= window && k + window < n)) {
        const Point before = curve.nodes[k] - curve.nodes[(k + n - window) % n];
        const Point after = curve.nodes[(k + window) % n] - curve.nodes[k];
        bend = before.dot(after) < least_cosine * before.norm() * after.norm();
      }
      if (least)
        result.push_back(0.5 * (curve.nodes[k] + nodes[other[first + k]]));
      else if (bend)
        result.push_back(curve.nodes[k]);
    }
    if (!curve.closed && n > 0) {
      if (curve.junction[0] >= 0)
        result.push_back(curve.nodes.front());
      if (curve.junction[1] >= 0)
        result.push_back(curve.nodes.back());
    }
    first += n;
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
