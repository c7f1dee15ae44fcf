// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <linelet/screen/tensor_splats.h>
#include <linelet/support/threads.h>

#include "eye_light.h"
#include "glyph_footprint.h"

namespace linelet {

namespace {

/** \brief An ellipsoid x = E s, |s| = 1, in pixels: A = E E' gives the border of its
 * picture, the depth of its surface and its normals. */
struct Ellipsoid {
  Point at = Point::Zero();
  double pixels_per_unit = 1;
  Eigen::Matrix2d inverse; // of the upper left of A
  Eigen::Vector2d tilt;    // depth of the middle of the chord a pixel
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
};

} // namespace

GlyphImage
drawEllipsoids(const std::vector<TensorGlyph>& glyphs,
               const Camera& camera,
               unsigned threads)
{
  GlyphImage image;
  image.width = camera.width;
  image.height = camera.height;
  image.pixels.resize(static_cast<std::size_t>(camera.width) *
                      static_cast<std::size_t>(camera.height));
  std::vector<double> depth(image.pixels.size(),
                            std::numeric_limits<double>::infinity());
  std::vector<Ellipsoid> ellipsoids;
  for (const TensorGlyph& glyph : glyphs) {
    ellipsoids.emplace_back(glyph, camera);
    if (!ellipsoids.back().seen)
      ellipsoids.pop_back();
  }
  const int count = threadCount(threads);
  const int bands = std::min(4 * count, std::max(1, camera.height));
#pragma omp parallel for num_threads(count) schedule(dynamic, 1)
  for (int band = 0; band < bands; ++band) {
    const auto row = [&](int number) {
      return static_cast<int>(std::int64_t{camera.height} * number / bands);
    };
    for (const Ellipsoid& e : ellipsoids) {
      const screen::PixelBox box(
          e.at.x(), e.at.y(), e.width, e.height, image.width, row(band + 1));
      for (int y = std::max(box.top, row(band)); y <= box.bottom; ++y)
        for (int x = box.left; x <= box.right; ++x) {
          const Eigen::Vector2d d(x + 0.5 - e.at.x(), y + 0.5 - e.at.y());
          const double inside = 1 - d.dot(e.inverse * d);
          if (inside < 0)
            continue;
          const double away = e.tilt.dot(d) - std::sqrt(e.bulge * inside);
          const double here = e.at.z() + away / e.pixels_per_unit;
          const std::size_t pixel =
              static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
              static_cast<std::size_t>(x);
          if (!(here < depth[pixel]))
            continue;
          depth[pixel] = here;
          const Point normal = (e.full * Point(d.x(), d.y(), away)).normalized();
          image.pixels[pixel] = screen::lit(e.color, normal);
        }
    }
  }
  return image;
}

} // namespace linelet
