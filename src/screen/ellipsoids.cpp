// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <linelet/screen/tensor_splats.h>

#include "eye_light.h"
#include "opaque_image.h"

namespace linelet {

namespace {

/** \brief An ellipsoid x = E s, |s| = 1, in pixels: A = E E' gives the border of its
 * picture, the depth of its surface and its normals. */
struct Ellipsoid {
  Point at = Point::Zero();
  double pixels_per_unit = 1;
  Eigen::Matrix2d inverse; // of the upper left of A
  Eigen::Vector2d tilt;    // depth of the middle of the chord per pixel
  double bulge = 0;        // half of the longest chord, squared
  Eigen::Matrix3d full;    // inverse of A
  double width = 0, height = 0;
  std::array<float, 3> color{};
  bool seen = false;

  Ellipsoid(const TensorGlyph& glyph, const Camera& camera)
  {
    const screen::Footprint print(glyph, camera);
    if (!print.seen)
      return;
    at = print.at;
    pixels_per_unit = camera.focalLength() / (camera.perspective() ? at.z() : 1);
    // At least a pixel thick: flat ones would have no surface.
    constexpr double least = 0.25;
    const Eigen::Matrix3d a =
        print.axes * print.axes.transpose() + Eigen::Matrix3d::Identity() * least;
    full = a.inverse();
    inverse = a.topLeftCorner<2, 2>().inverse();
    tilt = inverse * a.block<2, 1>(0, 2);
    bulge = std::max(0.0, a(2, 2) - a.block<1, 2>(2, 0).dot(tilt));
    width = std::sqrt(a(0, 0));
    height = std::sqrt(a(1, 1));
    color = glyph.color;
    seen = full.allFinite() && inverse.allFinite();
  }

  screen::PixelBox
  box(int pixels, int end) const
  {
    return {at.x(), at.y(), width, height, pixels, end};
  }

  double
  depthAt(const Eigen::Vector2d& pixel) const
  {
    return at.z() + awayAt(pixel) / pixels_per_unit;
  }

  std::array<float, 4>
  colorAt(const Eigen::Vector2d& pixel) const
  {
    const Eigen::Vector2d d = pixel - at.head<2>();
    return screen::lit(color, (full * Point(d.x(), d.y(), awayAt(pixel))).normalized());
  }

private:
  /** \brief How far beyond the middle its surface is, in pixels; NaN beside it. */
  double
  awayAt(const Eigen::Vector2d& pixel) const
  {
    const Eigen::Vector2d d = pixel - at.head<2>();
    const double inside = 1 - d.dot(inverse * d);
    return inside < 0 ? std::numeric_limits<double>::quiet_NaN()
                      : tilt.dot(d) - std::sqrt(bulge * inside);
  }
};

} // namespace

GlyphImage
drawEllipsoids(const std::vector<TensorGlyph>& glyphs,
               const Camera& camera,
               unsigned threads)
{
  std::vector<Ellipsoid> ellipsoids;
  for (const TensorGlyph& glyph : glyphs) {
    ellipsoids.emplace_back(glyph, camera);
    if (!ellipsoids.back().seen)
      ellipsoids.pop_back();
  }
  return screen::drawOpaque(ellipsoids, camera, threads);
}

} // namespace linelet
