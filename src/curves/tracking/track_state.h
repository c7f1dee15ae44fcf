// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>

#include <linelet/support/points.h>

namespace linelet {

/** \brief What is known of a curve at one of its places: a Kalman filter over arc
 * length.
 *
 * The curvature is a random walk. Offset, slope and curvature across the curve are
 * uncertain alike in both directions, so one 3 x 3 covariance serves both. */
struct TrackState {
  Point at = Point::Zero();         ///< a place of the curve
  Point direction = Point::UnitX(); ///< unit tangent there
  Point curvature = Point::Zero();  ///< change of the tangent per length
  Eigen::Matrix3d covariance =
      Eigen::Matrix3d::Identity(); ///< offset, slope, curvature

  /** \brief Where the curve is expected \a length further on; nothing is changed. */
  Point
  ahead(double length) const
  {
    return at + length * direction + 0.5 * length * length * curvature;
  }

  /** \brief Goes on by \a length.
   * \param[in] walk variance of the change of curvature per length, 1 / length^3 */
  void
  advance(double length, double walk);

  /** \brief Takes in a point.
   * \param[in] offset of the point from \ref at, across the curve
   * \param[in] variance of the points about the curve, per coordinate
   * \param[in] weight probability that the point is one of the curve */
  void
  observe(const Point& offset, double variance, double weight);

  /** \brief The part of \a v across the curve. */
  Point
  across(const Point& v) const
  {
    return v - direction.dot(v) * direction;
  }

  /** \brief Turns about, to follow the curve the other way. */
  void
  reverse()
  {
    direction = -direction;
    // The slope changes its sign with the direction, offset and curvature do not.
    for (const int k : {0, 2})
      covariance(1, k) = covariance(k, 1) = -covariance(1, k);
  }
};

} // namespace linelet
