// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "explained_points.h"

#include <algorithm>

namespace linelet {

namespace {

// Of the noise that is fitted as normal: scans have points farther off than that.
constexpr double tails = 6; // standard deviations

} // namespace

void
explainPoints(TrackedScene& scene, const Track& track, const TrackFit& fit, bool clear)
{
  for (std::size_t k = 0; k < fit.points.size(); ++k)
    if (fit.explained[k])
      scene.taken[fit.points[k]] = 1;
  Indices left;
  for (const Track::Member& m : track.members)
    if (m.weight > 0.5 && !scene.taken[m.index])
      left.push_back(m.index);
  std::sort(left.begin(), left.end());
  const double reach = tails * fit.fit.noise;
  for (const ModelCurve& curve : fit.fit.curves)
    for (std::size_t e = 0; e < curve.edges() && !left.empty(); ++e)
      scene.grid.forEachRunInCylinder(
          curve.from(e), curve.to(e), reach, [&](std::size_t begin, std::size_t end) {
            auto i = std::lower_bound(left.begin(), left.end(), begin);
            for (; i != left.end() && *i < end; ++i)
              if (squaredDistance(curve, e, scene.points()[*i]) <= reach * reach)
                scene.taken[*i] = 1;
          });
  if (!clear)
    return;
  const double own = own_width * fit.fit.noise;
  for (const ModelCurve& curve : fit.fit.curves)
    for (std::size_t e = 0; e < curve.edges(); ++e)
      scene.grid.forEachRunInCylinder(
          curve.from(e), curve.to(e), own, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
              if (squaredDistance(curve, e, scene.points()[i]) <= own * own)
                scene.taken[i] = 1;
          });
}

} // namespace linelet
