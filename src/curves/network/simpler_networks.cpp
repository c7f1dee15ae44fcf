// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "simpler_networks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "bridging.h"

namespace linelet {

namespace {

constexpr std::array<double, 4> gaps = {1.5, 3, 6, 12}; // in units
// Across a narrow gap there may be a corner; ends that lie farther apart have to agree.
constexpr double widest_corner = 2;            // in units
constexpr double most_disagreement = M_PI / 3; // of either end with the gap
constexpr double end_reach = 0.5;              // of a gap, for the direction of an end
// Curves shorter than this share of the total length are left out.
constexpr double short_share = 0.25;
// A curve keeps at least this many times the length that is cut off its free ends.
constexpr double least_rest = 2;

/** \brief \a curves with free ends shortened by \a cut. */
ModelCurves
shortened(const ModelCurves& curves, double cut)
{
  ModelCurves result = curves;
  for (ModelCurve& curve : result) {
    const double total = length(curve);
    if (curve.closed || total < 2 * (1 + least_rest) * cut)
      continue;
    const auto nodes = static_cast<std::ptrdiff_t>(
        std::round(cut / total * static_cast<double>(curve.edges())));
    if (curve.junction[1] < 0)
      curve.nodes.erase(curve.nodes.end() - nodes, curve.nodes.end());
    if (curve.junction[0] < 0)
      curve.nodes.erase(curve.nodes.begin(), curve.nodes.begin() + nodes);
    curve.counts.clear();
  }
  return result;
}

std::size_t
freeEnds(const ModelCurves& curves)
{
  std::size_t count = 0;
  for (const ModelCurve& curve : curves)
    for (const int junction : curve.junction)
      count += !curve.closed && junction < 0;
  return count;
}

/** \brief The largest scale at a free end of \a curves. */
double
scaleAtEnds(const ModelCurves& curves, const ScaleField& scales)
{
  double widest = 0;
  for (const ModelCurve& curve : curves) {
    if (curve.closed)
      continue;
    if (curve.junction[0] < 0)
      widest = std::max(widest, scales.at(curve.nodes.front()));
    if (curve.junction[1] < 0)
      widest = std::max(widest, scales.at(curve.nodes.back()));
  }
  return widest;
}

} // namespace

std::vector<ModelCurves>
simplerNetworks(const ModelCurves& curves, double scale_unit, const ScaleField* scales)
{
  const double unit = scale_unit * (scales ? scaleAtEnds(curves, *scales) : 1);
  std::vector<ModelCurves> result;
  const std::size_t ends = freeEnds(curves);
  for (const double gap : gaps)
    for (const double cut : {0.0, gap}) {
      ModelCurves joined = bridgeGaps(shortened(curves, cut * unit),
                                      (gap + cut) * unit,
                                      0,
                                      end_reach * gap * unit,
                                      gap > widest_corner ? most_disagreement : M_PI);
      if (freeEnds(joined) < ends)
        result.push_back(std::move(joined));
    }
  const double all = length(curves);
  for (std::size_t c = 0; c < curves.size(); ++c)
    if (length(curves[c]) < short_share * all) {
      result.push_back(curves);
      result.back().erase(result.back().begin() + static_cast<std::ptrdiff_t>(c));
      // Ends that were attached to it become free.
      for (ModelCurve& curve : result.back())
        curve.junction = {-1, -1};
    }
  return result;
}

} // namespace linelet
