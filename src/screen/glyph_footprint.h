// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cmath>

#include <Eigen/Core>

#include <linelet/screen/tensor_glyph.h>
#include <linelet/support/camera.h>

namespace linelet::screen {

/** \brief A glyph in the picture: its position, and its axes in pixels (right, down,
 * away), as in a parallel projection at its depth. */
struct Footprint {
  Point at = Point::Zero(); ///< pixels, and depth in the unit of the cloud
  Eigen::Matrix3d axes = Eigen::Matrix3d::Zero(); ///< columns: half axes
  bool seen = false;

  Footprint(const TensorGlyph& glyph, const Camera& camera)
  {
    at = camera.project(glyph.center);
    seen = at.allFinite() && glyph.half_lengths.allFinite() && glyph.axes.allFinite() &&
           at.z() >= camera.near && at.z() <= camera.far &&
           (at.z() > 0 || !camera.perspective());
    if (!seen)
      return;
    const double scale = camera.focalLength() / (camera.perspective() ? at.z() : 1);
    axes = camera.axes * glyph.axes * (glyph.half_lengths * scale).asDiagonal();
  }
};

/** \brief Pixels of a picture around a place. */
struct PixelBox {
  int left, right, top, bottom; ///< all included; empty if left > right or top > bottom

  PixelBox(
      double x, double y, double half_width, double half_height, int width, int end)
      : left(first(x - half_width)),
        right(last(x + half_width, width)),
        top(first(y - half_height)),
        bottom(last(y + half_height, end))
  {
  }

private:
  static int
  first(double value)
  {
    return static_cast<int>(std::clamp(std::ceil(value - 0.5), 0., 1e6));
  }
  static int
  last(double value, int end)
  {
    return static_cast<int>(std::clamp(std::floor(value - 0.5), -1., end - 1.));
  }
};

} // namespace linelet::screen
