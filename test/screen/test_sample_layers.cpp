// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <stdexcept>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_real_distribution.hpp>
#include <gtest/gtest.h>

#include <linelet/screen/sample_layers.h>

using namespace linelet;

namespace {

Points
crowd(std::size_t count, unsigned seed)
{
  boost::random::mt19937 random(seed);
  boost::random::uniform_real_distribution<double> uniform(-3, 3);
  Points points;
  while (points.size() < count)
    points.emplace_back(uniform(random), uniform(random), uniform(random));
  return points;
}

Camera
cameraOf(bool perspective)
{
  Camera camera;
  camera.lookAt(Point(-9, 4, 5), Point(0, 0, 0));
  camera.width = 47;
  camera.height = 33;
  camera.field_of_view = perspective ? 45 : 0;
  camera.view_height = 8;
  return camera;
}

TEST(Camera, ProjectsAndUnprojects)
{
  for (const bool perspective : {false, true}) {
    const Camera camera = cameraOf(perspective);
    const Point center = camera.project(Point(0, 0, 0));
    EXPECT_NEAR(center.x(), 23.5, 1e-9);
    EXPECT_NEAR(center.y(), 16.5, 1e-9);
    EXPECT_NEAR(center.z(), std::sqrt(81 + 16 + 25.), 1e-9);
    EXPECT_LT(camera.project(Point(0, 0, 1)).y(), center.y()); // up is up
    for (const Point& p : crowd(100, 1))
      EXPECT_LT((camera.unproject(camera.project(p)) - p).norm(), 1e-9);
  }
}

TEST(SampleLayers, SeeTheNearestPointThatCoversThem)
{
  constexpr unsigned seed = 2;
  Points points = crowd(300, seed);
  points[7].x() = std::nan("");
  points[8] = Point(-9, 4, 5) * 2; // behind the eye
  for (const bool perspective : {false, true})
    for (const double diameter : {0., 0.5}) {
      const Camera camera = cameraOf(perspective);
      const double size = 5;
      const SampleLayers samples = sampleLayers(points, camera, size, diameter, 1);
      std::size_t covered = 0;
      for (int row = 0; row < camera.height; ++row)
        for (int column = 0; column < camera.width; ++column) {
          Index nearest = SampleLayers::nothing;
          double depth = 1e300;
          for (std::size_t i = 0; i < points.size(); ++i) {
            const Point at = camera.project(points[i]);
            if (!at.allFinite() || at.z() <= 0)
              continue;
            const double scale = camera.focalLength() / (perspective ? at.z() : 1);
            const double radius = std::max(size, diameter * scale) / 2;
            if (std::hypot(column + 0.5 - at.x(), row + 0.5 - at.y()) <= radius &&
                at.z() < depth) {
              depth = at.z();
              nearest = static_cast<Index>(i);
            }
          }
          const std::size_t k = samples.at(column, row);
          ASSERT_EQ(samples.point[k], nearest) << column << " " << row;
          if (nearest == SampleLayers::nothing) {
            EXPECT_TRUE(std::isnan(samples.x[k]));
            continue;
          }
          ++covered;
          const Point at =
              Point(samples.x[k], samples.y[k], samples.z[k]) + samples.origin;
          const Point pixel = camera.project(at);
          EXPECT_NEAR(pixel.x(), column + 0.5, 1e-3);
          EXPECT_NEAR(pixel.y(), row + 0.5, 1e-3);
          EXPECT_NEAR(pixel.z(), depth, 1e-5);
        }
      EXPECT_GT(covered, 200u);
    }
}

TEST(SampleLayers, AreTheSameForAnyNumberOfThreadsAndFarFromTheOrigin)
{
  Points points = crowd(3000, 3);
  const Camera camera = cameraOf(true);
  const SampleLayers one = sampleLayers(points, camera, 3, 0, 8, 1);
  EXPECT_EQ(sampleLayers(points, camera, 3, 0, 8, 4).point, one.point);
  const Point offset(5e5, 5.8e6, 100);
  Camera there = camera;
  there.eye += offset;
  for (Point& p : points)
    p += offset;
  const SampleLayers far = sampleLayers(points, there, 3, 0, 8, 2);
  for (std::size_t k = 0; k < one.x.size(); ++k)
    if (one.point[k] != SampleLayers::nothing && far.point[k] == one.point[k]) {
      EXPECT_NEAR(far.x[k], one.x[k], 1e-4);
    }
}

TEST(SampleLayers, RefuseInvalidSettings)
{
  const Points points = crowd(3, 4);
  const Camera camera = cameraOf(true);
  EXPECT_THROW(sampleLayers(points, camera, 3, 0, 3), std::invalid_argument);
  EXPECT_THROW(sampleLayers(points, camera, 0), std::invalid_argument);
  EXPECT_THROW(sampleLayers(points, camera, std::nan("")), std::invalid_argument);
  EXPECT_EQ(sampleLayers({}, camera, 3).point.size(), 8u * 47 * 33);
}

} // namespace
