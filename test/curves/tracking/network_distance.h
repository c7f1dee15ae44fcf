// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>

#include <linelet/curves/curve_network.h>

namespace linelet {

inline double
distanceTo(const CurveNetwork& network, const Point& p)
{
  double best = 1e300;
  for (const Curve& curve : network.curves)
    for (std::size_t k = 0; k + 1 < curve.points.size(); ++k) {
      const Point a = curve.points[k], ab = curve.points[k + 1] - a;
      const double t =
          std::clamp(ab.dot(p - a) / std::max(ab.squaredNorm(), 1e-300), 0.0, 1.0);
      best = std::min(best, (a + t * ab - p).norm());
    }
  return best;
}

/** \brief Share of the curves at(0, x), ..., at(count - 1, x) within \a tolerance of
 * \a network, for x between \a from and \a to. */
template <class At>
double
shareNear(const CurveNetwork& network,
          const At& at,
          int count,
          double from,
          double to,
          double tolerance)
{
  constexpr int places = 200; // on each
  int near = 0;
  for (int k = 0; k < count; ++k)
    for (int i = 0; i < places; ++i)
      near += distanceTo(network, at(k, from + (i + 0.5) / places * (to - from))) <=
              tolerance;
  return static_cast<double>(near) / (count * places);
}

} // namespace linelet
