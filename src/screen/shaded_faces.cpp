// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/screen/shaded_faces.h>

#include <limits>
#include <utility>

#include "eye_light.h"
#include "opaque_image.h"

namespace linelet {

namespace {

/** \brief A face in the picture. */
class Polygon {
public:
  /** \return false where it is not to be drawn */
  bool
  set(const Face& face, const std::array<float, 3>& own, const Camera& camera)
  {
    center = {camera.width / 2.0, camera.height / 2.0};
    focal_length = camera.focalLength();
    perspective = camera.perspective();
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

  screen::PixelBox
  box(int width, int end) const
  {
    const Eigen::Vector2d middle = (low + high) / 2, half = (high - low) / 2;
    return {middle.x(), middle.y(), half.x(), half.y(), width, end};
  }

  double
  depthAt(const Eigen::Vector2d& pixel) const
  {
    if (!covers(pixel))
      return std::numeric_limits<double>::quiet_NaN();
    const Eigen::Vector2d at = (pixel - center) / focal_length;
    return perspective
               ? offset / (normal.x() * at.x() + normal.y() * at.y() + normal.z())
               : (offset - normal.x() * at.x() - normal.y() * at.y()) / normal.z();
  }

  std::array<float, 4>
  colorAt(const Eigen::Vector2d& /*pixel*/) const
  {
    return color;
  }

private:
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

  std::vector<Eigen::Vector2d> corners; // pixels
  Eigen::Vector2d low, high, center;    // of the box around them, and of the picture
  Point normal = Point::Zero();         // right, down, away
  double offset = 0;                    // normal . (any place of the face, seen so)
  double focal_length = 1;
  bool perspective = false;
  std::array<float, 4> color{};
};

} // namespace

GlyphImage
drawFaces(const std::vector<Face>& faces,
          const std::vector<std::array<float, 3>>& colors,
          const Camera& camera,
          unsigned threads)
{
  std::vector<Polygon> polygons;
  for (const Face& face : faces) {
    Polygon polygon;
    if (polygon.set(face, colors[face.part], camera))
      polygons.push_back(std::move(polygon));
  }
  return screen::drawOpaque(polygons, camera, threads);
}

} // namespace linelet
