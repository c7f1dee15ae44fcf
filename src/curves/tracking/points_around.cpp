// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "points_around.h"

#include <algorithm>

#include "curves/ridges/model_curve.h"

namespace linelet {

PointsAround::PointsAround(const TrackedScene& scene,
                           const ModelCurve& curve,
                           double distance)
{
  for (std::size_t e = 0; e < curve.edges(); ++e) {
    const Point cap =
        distance * (curve.to(e) - curve.from(e)).stableNormalized(); // rounds the end
    scene.grid.forEachRunInCylinder(
        curve.from(e) - cap,
        curve.to(e) + cap,
        distance,
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t i = begin; i < end; ++i) {
            const double squared = squaredDistance(curve, e, scene.points()[i]);
            if (!scene.taken[i] && squared <= distance * distance)
              points_.emplace_back(static_cast<Index>(i), squared);
          }
        });
  }
  std::sort(points_.begin(), points_.end());
  const auto is_same = [](const auto& a, const auto& b) { return a.first == b.first; };
  points_.erase(std::unique(points_.begin(), points_.end(), is_same), points_.end());
}

Indices
PointsAround::within(double distance) const
{
  Indices result;
  for (const auto& [i, squared] : points_)
    if (squared <= distance * distance)
      result.push_back(i);
  return result;
}

double
PointsAround::count(double from, double to) const
{
  const auto is_between = [&](const std::pair<Index, double>& point) {
    return point.second > from * from && point.second <= to * to;
  };
  return static_cast<double>(std::count_if(points_.begin(), points_.end(), is_between));
}

} // namespace linelet
