// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/screen/shaded_faces.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include <linelet/support/threads.h>

#include "eye_light.h"
#include "glyph_footprint.h"

namespace linelet {

namespace {

/** \brief A face in the picture. */
struct Polygon {
  std::vector<Eigen::Vector2d> corners; // pixels
  Point normal = Point::Zero();         // right, down, away
  double offset = 0;                    // normal . (any place of the face, seen so)
  std::array<float, 4> color{};
  Eigen::Vector2d low, high;

  /** \return false where it is not to be drawn */
  bool
  set(const Face& face, const std::array<float, 3>& own, const Camera& camera)
  {
    low.setConstant(std::numeric_limits<double>::infinity());
    high = -low;
    for (const Point& corner : face.corners) {
      const Point at = camera.project(corner);
      if (!at.allFinite() || at.z() < camera.near || at.z() > camera.far ||
          (camera.perspective() && !(at.z() > 0)))
        return false;
      corners.emplace_back(at.x(), at.y());
      low = low.cwiseMin(corners.back());
      high = high.cwiseMax(corners.back());
    }
    normal = camera.axes * face.normal;
    if (corners.size() < 3 || !normal.allFinite())
      return false;
    const Point place = camera.axes * (face.corners.front() - camera.eye);
    offset = normal.dot(place);
    const bool away = (camera.perspective() ? offset : normal.z()) > 0; // from the eye
    color = screen::lit(own, away ? Point(-normal) : normal);
    return true;
  }

  bool
  covers(const Eigen::Vector2d& at) const
  {
    bool left = false, right = false;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const Eigen::Vector2d side = corners[(k + 1) % corners.size()] - corners[k];
      const Eigen::Vector2d to = at - corners[k];
      const double turn = side.x() * to.y() - side.y() * to.x();
      left = left || turn < 0;
      right = right || turn > 0;
    }
    return !(left && right);
  }

  /** \brief Depth of the face behind a pixel. */
  double
  depth(const Eigen::Vector2d& at, const Camera& camera) const
  {
    const double scale = 1 / camera.focalLength();
    const double x = (at.x() - camera.width / 2.0) * scale;
    const double y = (at.y() - camera.height / 2.0) * scale;
    return camera.perspective()
               ? offset / (normal.x() * x + normal.y() * y + normal.z())
               : (offset - normal.x() * x - normal.y() * y) / normal.z();
  }
};

} // namespace

GlyphImage
drawFaces(const std::vector<Face>& faces,
          const std::vector<std::array<float, 3>>& colors,
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
  std::vector<Polygon> polygons;
  for (const Face& face : faces) {
    Polygon polygon;
    if (polygon.set(face, colors[face.part], camera))
      polygons.push_back(std::move(polygon));
  }
  const int count = threadCount(threads);
  const int bands = std::min(4 * count, std::max(1, camera.height));
#pragma omp parallel for num_threads(count) schedule(dynamic, 1)
  for (int band = 0; band < bands; ++band) {
    const auto row = [&](int number) {
      return static_cast<int>(std::int64_t{camera.height} * number / bands);
    };
    for (const Polygon& polygon : polygons) {
      const Eigen::Vector2d middle = (polygon.low + polygon.high) / 2;
      const Eigen::Vector2d half = (polygon.high - polygon.low) / 2;
      const screen::PixelBox box(
          middle.x(), middle.y(), half.x(), half.y(), image.width, row(band + 1));
      for (int y = std::max(box.top, row(band)); y <= box.bottom; ++y)
        for (int x = box.left; x <= box.right; ++x) {
          const Eigen::Vector2d at(x + 0.5, y + 0.5);
          if (!polygon.covers(at))
            continue;
          const double here = polygon.depth(at, camera);
          const std::size_t pixel =
              static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
              static_cast<std::size_t>(x);
          if (!(here < depth[pixel]))
            continue;
          depth[pixel] = here;
          image.pixels[pixel] = polygon.color;
        }
    }
  }
  return image;
}

} // namespace linelet
