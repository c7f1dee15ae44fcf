// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "explained_points.h"

#include <algorithm>

namespace linelet {

namespace {

// Of the noise that is fitted as normal: scans have points farther off than that.
constexpr double tails = 6; // standard deviations

/** \brief Calls \a visit with the points within \a distance of \a curve, with those
 * near a node twice. */
template <class Visit>
void
forEachPointNear(const TrackedScene& scene,
                 const ModelCurve& curve,
                 double distance,
                 const Visit& visit)
{
  for (std::size_t e = 0; e < curve.edges(); ++e)
    scene.grid.forEachRunInCylinder(
        curve.from(e), curve.to(e), distance, [&](std::size_t begin, std::size_t end) {
          for (std::size_t i = begin; i < end; ++i)
            if (squaredDistance(curve, e, scene.points()[i]) <= distance * distance)
              visit(i);
        });
}

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
  for (const ModelCurve& curve : fit.fit.curves)
    forEachPointNear(scene, curve, tails * fit.fit.noise, [&](std::size_t i) {
      if (std::binary_search(left.begin(), left.end(), static_cast<Index>(i)))
        scene.taken[i] = 1;
    });
  if (!clear)
    return;
  for (const ModelCurve& curve : fit.fit.curves)
    forEachPointNear(scene, curve, own_width * fit.fit.noise, [&](std::size_t i) {
      scene.taken[i] = 1;
    });
}

ModelCurves
withoutExplained(const TrackedScene& scene, ModelCurves curves, double needed)
{
  std::vector<double> clearest(scene.points().size(), 0); // evidence
  for (const ModelCurve& curve : curves)
    forEachPointNear(scene, curve, own_width * curve.noise, [&](std::size_t i) {
      clearest[i] = std::max(clearest[i], curve.evidence);
    });
  const auto is_explained = [&](const ModelCurve& curve) {
    double all = 0, own = 0;
    forEachPointNear(scene, curve, own_width * curve.noise, [&](std::size_t i) {
      all += 1;
      own += clearest[i] > curve.evidence ? 0 : 1;
    });
    return 2 * own < all && curve.evidence * own < needed * all;
  };
  curves.erase(std::remove_if(curves.begin(), curves.end(), is_explained),
               curves.end());
  return curves;
}

} // namespace linelet
