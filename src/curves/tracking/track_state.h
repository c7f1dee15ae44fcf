// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>

#include <linelet/support/points.h>

namespace linelet {

/** \brief What is known about a curve at one position: the state of a Kalman filter
 * over arc length.
 *
 * The curvature is a random walk. Offset, slope and curvature have the same uncertainty
 * in both directions across the curve, so one 3 x 3 covariance serves both. */
struct TrackState {
  Point at = Point::Zero();         ///< a place of the curve
  Point direction = Point::UnitX(); ///< unit tangent there
  Point curvature = Point::Zero();  ///< change of the tangent per length
  /// Offset, slope, curvature
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();

  /** \brief Where the curve is expected \a length farther on; the state is unchanged.
   */
  Point
  ahead(double length) const
  {
    return at + length * direction + 0.5 * length * length * curvature;
  }

  /** \brief Advances by \a length.
   * \param[in] walk variance of the change of curvature per length, 1 / length^3 */
  void
  advance(double length, double walk);

  /** \brief Updates the state with a point.
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

  /** \brief Reverses direction, to follow the curve the other way. */
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
