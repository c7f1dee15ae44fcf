// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_real_distribution.hpp>

#include <Eigen/Geometry>

#include <linelet/screen/shaded_faces.h>

using namespace linelet;

namespace {

const std::vector<std::array<float, 3>> colors = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

Camera
cameraOf(bool perspective)
{
  Camera camera;
  camera.lookAt(Point(3, -8, 5), Point(0, 0, 0));
  camera.width = 160;
  camera.height = 120;
  camera.field_of_view = perspective ? 40 : 0;
  camera.view_height = 7;
  return camera;
}

/** \brief A triangle with its normal, belonging to the part with its number. */
Face
triangle(const Point& a, const Point& b, const Point& c, std::size_t number)
{
  Face face;
  face.corners = {a, b, c};
  face.normal = (b - a).cross(c - a).normalized();
  face.part = static_cast<Index>(number % 3);
  return face;
}

/** \brief Where the ray of a pixel first meets a face, by the barycentric coordinates
 * of the place: number of the face, or none. */
std::size_t
hitBy(const std::vector<Face>& faces, const Camera& camera, double x, double y)
{
  const Point from = camera.unproject(Point(x, y, 0.5));
  const Point way = camera.unproject(Point(x, y, 1.5)) - from;
  std::size_t hit = faces.size();
  double first = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < faces.size(); ++k) {
    Eigen::Matrix3d sides;
    sides << faces[k].corners[1] - faces[k].corners[0],
        faces[k].corners[2] - faces[k].corners[0], -way;
    const Point at = sides.inverse() * (from - faces[k].corners[0]);
    if (at.x() < 0 || at.y() < 0 || at.x() + at.y() > 1 || !(at.z() < first))
      continue;
    first = at.z();
    hit = k;
  }
  return hit;
}

TEST(ShadedFaces, EveryPixelShowsTheFaceThatItsRayMeetsFirst)
{
  const unsigned seed = 5;
  SCOPED_TRACE("seed " + std::to_string(seed));
  boost::random::mt19937 random(seed);
  boost::random::uniform_real_distribution<double> uniform(-2, 2);
  std::vector<Face> faces;
  const auto place = [&] {
    return Point(uniform(random), uniform(random), uniform(random));
  };
  for (std::size_t k = 0; k < 12; ++k) {
    const Point a = place(), b = place(), c = place();
    faces.push_back(triangle(a, b, c, k));
  }
  for (const bool perspective : {false, true}) {
    const Camera camera = cameraOf(perspective);
    const GlyphImage image = drawFaces(faces, colors, camera, 2);
    int seen = 0;
    for (int y = 0; y < camera.height; ++y)
      for (int x = 0; x < camera.width; ++x) {
        const std::size_t hit = hitBy(faces, camera, x + 0.5, y + 0.5);
        const auto& pixel = image.at(x, y);
        ASSERT_EQ(pixel[3], hit < faces.size() ? 1 : 0) << x << ", " << y;
        for (std::size_t c = 0; c < 3 && hit < faces.size(); ++c)
          ASSERT_EQ(pixel[c] > 0, hit % 3 == c) << x << ", " << y;
        seen += hit < faces.size() ? 1 : 0;
      }
    EXPECT_GT(seen, 2000);
    EXPECT_EQ(image.pixels, drawFaces(faces, colors, camera, 1).pixels);
  }
}

TEST(ShadedFaces, AreLitTheSameFromEitherSide)
{
  const Camera camera = cameraOf(false);
  Face face = triangle({-1, -1, 0}, {1, -1, 0}, {0, 1, 0}, 0);
  const GlyphImage one = drawFaces({face}, colors, camera);
  face.normal = -face.normal;
  EXPECT_EQ(one.pixels, drawFaces({face}, colors, camera).pixels);
  // Facing the light is brighter than seen at a slant.
  const Point to_light = camera.axes.transpose() * Point(-0.4, -0.6, -0.7).normalized();
  face.normal = to_light;
  EXPECT_GT(drawFaces({face}, colors, camera).at(80, 60)[0], one.at(80, 60)[0]);
  EXPECT_NEAR(drawFaces({face}, colors, camera).at(80, 60)[0], 1, 1e-6);
}

TEST(ShadedFaces, WhatCannotBeDrawnIsLeftOut)
{
  const double nan = std::nan("");
  Face good = triangle({-1, -1, 0}, {1, -1, 0}, {0, 1, 0}, 0);
  Camera camera = cameraOf(true);
  const GlyphImage expected = drawFaces({good}, colors, camera);
  Face two = good, unknown = good, behind = good, crooked = good;
  two.corners.pop_back();
  unknown.corners[1].z() = nan;
  behind.corners[0] = Point(6, -16, 10); // behind the eye
  crooked.normal.setConstant(nan);
  EXPECT_EQ(drawFaces({two, unknown, good, behind, crooked}, colors, camera).pixels,
            expected.pixels);
  EXPECT_EQ(drawFaces({}, colors, camera).at(80, 60)[3], 0);
  camera.near = 20;
  EXPECT_EQ(drawFaces({good}, colors, camera).at(80, 60)[3], 0);
}

} // namespace
