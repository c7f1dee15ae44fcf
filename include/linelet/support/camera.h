// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>
#include <limits>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <linelet/support/points.h>
#include <linelet/support/visibility.h>

namespace LINELET_PUBLIC linelet {

/** \brief A view of a scene: where the eye is, which way it looks, and the picture it
 * sees. Pixel (0, 0) spans 0 to 1 at the upper left. */
struct Camera {
  Point eye = Point::Zero();
  /// Rows: right, down, away from the eye; orthonormal.
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  double field_of_view = 60; ///< vertical, degrees in (0, 180); 0: parallel projection
  double view_height = 1;    ///< parallel projection: height of what is seen
  int width = 640, height = 480; ///< pixels
  double near = 0;               ///< nearest visible depth, unit of the scene
  double far = std::numeric_limits<double>::infinity(); ///< farthest visible depth

  /** \brief Places the camera at \a from and turns it toward \a target, with \a up
   * upward as far as possible. */
  void
  lookAt(const Point& from, const Point& target, const Point& up = Point::UnitZ())
  {
    eye = from;
    const Point forward = (target - from).normalized();
    Point right = forward.cross(up);
    if (!(right.norm() > 1e-9)) // straight up or down
      right = forward.cross(Point::UnitY());
    right.normalize();
    axes.row(0) = right;
    axes.row(1) = forward.cross(right);
    axes.row(2) = forward;
  }

  bool
  perspective() const
  {
    return field_of_view > 0;
  }

  /** \brief Half the height of the picture in the scene, at depth 1 (perspective) or at
   * any depth (parallel). */
  double
  halfHeight() const
  {
    constexpr double degree = M_PI / 180;
    return perspective() ? std::tan(field_of_view * degree / 2) : view_height / 2;
  }

  /** \brief Pixels per unit of length, at depth 1 (perspective) or at any depth
   * (parallel). */
  double
  focalLength() const
  {
    return height / (2 * halfHeight());
  }

  /** \brief Pixel coordinates and depth of \a point. */
  Point
  project(const Point& point) const
  {
    const Point at = axes * (point - eye);
    const double scale = focalLength() / (perspective() ? at.z() : 1);
    return {width / 2.0 + scale * at.x(), height / 2.0 + scale * at.y(), at.z()};
  }

  /** \brief The point at given pixel coordinates and depth. */
  Point
  unproject(const Point& pixel) const
  {
    const double scale = (perspective() ? pixel.z() : 1) / focalLength();
    return eye + axes.transpose() * Point((pixel.x() - width / 2.0) * scale,
                                          (pixel.y() - height / 2.0) * scale,
                                          pixel.z());
  }
};

} // namespace linelet
