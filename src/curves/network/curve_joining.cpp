// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "curve_joining.h"

#include <algorithm>
#include <utility>

namespace linelet {

void
turnRound(ModelCurve& curve)
{
  std::reverse(curve.nodes.begin(), curve.nodes.end());
  std::reverse(curve.counts.begin(), curve.counts.end());
  std::swap(curve.junction[0], curve.junction[1]);
}

void
appendBridge(ModelCurve& curve, const Points& bridge)
{
  curve.nodes.insert(curve.nodes.end(), bridge.begin(), bridge.end());
  // The bridge explains no points.
  if (!curve.counts.empty())
    curve.counts.insert(curve.counts.end(), bridge.size() + 1, 0.0);
}

void
appendCurve(ModelCurve& first, const Points& bridge, const ModelCurve& second)
{
  // Weighted by length, as the counts may be unknown.
  const double a = length(first), b = length(second);
  first.noise = (a * first.noise + b * second.noise) / (a + b);
  first.evidence += second.evidence;
  // Counts of only one half are of no use.
  if (second.counts.empty())
    first.counts.clear();
  appendBridge(first, bridge);
  first.nodes.insert(first.nodes.end(), second.nodes.begin(), second.nodes.end());
  if (!first.counts.empty())
    first.counts.insert(first.counts.end(), second.counts.begin(), second.counts.end());
  first.junction[1] = second.junction[1];
}

} // namespace linelet
