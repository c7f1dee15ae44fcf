// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <utility>

#include <linelet/curves/curve_network.h>

namespace linelet::io {

/** \brief The curve through \a vertices: closed, without the repeated vertex, if the
 * last equals the first. */
inline Curve
curveThrough(Points vertices)
{
  Curve curve;
  curve.closed = vertices.size() > 2 && vertices.front() == vertices.back();
  if (curve.closed) {
    vertices.pop_back();
    curve.front.kind = curve.back.kind = EndKind::Loop;
  }
  curve.points = std::move(vertices);
  return curve;
}

} // namespace linelet::io
