// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>

#include <linelet/support/points.h>

namespace linelet {

/** \brief Where the line from \a p along the unit vector \a d passes that from \a q
 * along the unit vector \a e: the midpoint of their closest points, if both are ahead
 * and not beyond \a far, and the lines are not within 10 degrees of parallel. */
inline std::optional<Point>
meetingAhead(const Point& p, const Point& d, const Point& q, const Point& e, double far)
{
  const Point w = q - p;
  const double c = d.dot(e), denominator = 1 - c * c;
  if (denominator < 0.03)
    return {};
  const double s = (w.dot(d) - c * w.dot(e)) / denominator;
  const double t = (c * w.dot(d) - w.dot(e)) / denominator;
  if (s < 0 || t < 0 || s > far || t > far)
    return {};
  return Point(0.5 * (p + s * d + q + t * e));
}

} // namespace linelet
