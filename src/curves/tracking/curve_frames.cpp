// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "curve_frames.h"

#include <Eigen/Geometry>

namespace linelet {

CurveFrames
framesOf(const ModelCurve& curve)
{
  CurveFrames frames;
  for (std::size_t e = 0; e < curve.edges(); ++e) {
    const Point direction = (curve.to(e) - curve.from(e)).normalized();
    Point first = e == 0 ? direction.unitOrthogonal() : frames.first.back();
    first = (first - first.dot(direction) * direction).normalized();
    frames.first.push_back(first);
    frames.second.push_back(direction.cross(first));
  }
  return frames;
}

} // namespace linelet
