// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "curves/ridges/model_curve.h"

namespace linelet {

/** \brief Unit vectors across each edge of a curve, carried along it without a twist:
 * with the edge's direction, right-handed. */
struct CurveFrames {
  Points first, second;
};

CurveFrames
framesOf(const ModelCurve& curve);

/** \brief Offset of \a p from the line of edge \a e of \a curve, in its frame. */
inline Eigen::Vector2d
offsetAcross(const ModelCurve& curve,
             const CurveFrames& frames,
             std::size_t e,
             const Point& p)
{
  const Point v = p - 0.5 * (curve.from(e) + curve.to(e));
  return {v.dot(frames.first[e]), v.dot(frames.second[e])};
}

} // namespace linelet
