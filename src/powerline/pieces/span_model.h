// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Core>

#include <linelet/support/points.h>

namespace linelet::powerline {

constexpr double widest_wire = 0.25; ///< meters, tolerance of a wire in a narrow beam

/** \brief A wire between its supports, in its own frame.
 *
 * s runs along a horizontal direction, t to the left of it, z up:
 * t = t0 + t1 s + t2 s^2 (wind blows the wire out); z is the catenary that has height
 * z0, slope z1 and half second derivative z2 at s = 0, to the fourth order in s. In a
 * span of 800 m a parabola is off by .15 m. */
struct SpanModel {
  Eigen::Vector2d origin = Eigen::Vector2d::Zero();
  Eigen::Vector2d direction = Eigen::Vector2d::UnitX(); ///< unit length
  Eigen::Vector3d t = Eigen::Vector3d::Zero();
  Eigen::Vector3d z = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero(); ///< of z, for unit noise
  double begin = 0, end = 0;                            ///< stretch that points support
  double sigma = 0.1;          ///< robust scale of the residuals, meters
  double tolerance = 0.25;     ///< largest distance of a point that belongs to the wire
  double widest = widest_wire; ///< largest tolerance: a wide beam scatters points

  /** \brief Whether its points do not fit into the tube of a wire in a narrow beam:
   * three deviations hold nearly all. */
  bool
  isWide() const
  {
    return 3 * sigma >= widest_wire;
  }

  static double
  value(const Eigen::Vector3d& c, double s)
  {
    return c[0] + s * (c[1] + s * c[2]);
  }

  static double
  slope(const Eigen::Vector3d& c, double s)
  {
    return c[1] + 2 * c[2] * s;
  }

  /** \brief The cubic and quartic coefficients of a catenary with \a c beyond its
   * parabola, z1 = sinh b, z2 = cosh b / 2a. */
  static Eigen::Vector2d
  beyondParabola(const Eigen::Vector3d& c)
  {
    const double squared = c[2] * c[2] / (1 + c[1] * c[1]);
    return {2 * c[1] * squared / 3, c[2] * squared / 3};
  }

  double
  height(double s) const
  {
    const Eigen::Vector2d more = beyondParabola(z);
    return value(z, s) + s * s * s * (more[0] + s * more[1]);
  }

  /** \brief Slope of \ref height. */
  double
  rise(double s) const
  {
    const Eigen::Vector2d more = beyondParabola(z);
    return slope(z, s) + s * s * (3 * more[0] + 4 * s * more[1]);
  }

  double
  along(const Point& p) const
  {
    return direction.dot(p.head<2>() - origin);
  }

  /** \brief Deviation of \a p from the wire, across it, to the left and upward. */
  Eigen::Vector2d
  residual(const Point& p, double s) const
  {
    const Eigen::Vector2d offset = p.head<2>() - origin;
    const double left = direction.x() * offset.y() - direction.y() * offset.x();
    const double steep = rise(s);
    return {left - value(t, s), (p.z() - height(s)) / std::sqrt(1 + steep * steep)};
  }

  double
  distance(const Point& p) const
  {
    return residual(p, along(p)).norm();
  }

  Point
  at(double s) const
  {
    const double left = value(t, s);
    return {origin.x() + s * direction.x() - left * direction.y(),
            origin.y() + s * direction.y() + left * direction.x(),
            height(s)};
  }

  /** \brief Unit tangent; the wire is taken as straight in plan. */
  Point
  tangent(double s) const
  {
    return Point(direction.x(), direction.y(), rise(s)).normalized();
  }

  double
  length() const
  {
    return end - begin;
  }

  /** \brief Standard deviation of the predicted height at \a s. */
  double
  uncertainty(double s) const
  {
    const Eigen::Vector3d x(1, s, s * s);
    return sigma * std::sqrt(std::max(0.0, x.dot(covariance * x)));
  }

  /** \brief The same curve in a frame turned along the wire, its origin in the middle.
   */
  SpanModel
  reframed() const;
};

constexpr double usual_cut = 0.3; ///< meters; points farther away have no weight

/** \brief Fits \a model to points with robust weights (Tukey's biweight, cut \a cut).
 *
 * Priors stabilize short wires: t2 is nearly 0 (otherwise a fit could swap between the
 * wires of a bundle), z2 that of usual sags. Updates coefficients, covariance, sigma
 * and tolerance, not begin and end.
 * \return false if fewer than 3 points have weight */
bool
fit(SpanModel& model,
    const Points& points,
    const Indices& members,
    double cut = usual_cut);

/** \brief Root mean square distance of points from a wire, meters; 0 without points. */
double
rootMeanSquare(const SpanModel& model, const Points& points, const Indices& members);

} // namespace linelet::powerline
