// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <limits>
#include <stdexcept>
#include <string>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <boost/random/uniform_real_distribution.hpp>
#include <gtest/gtest.h>

#include <linelet/tensor/eigen_analysis.h>
#include <linelet/tensor/neighborhood_tensor.h>

#include "screen/depth_camera.h"

using namespace linelet;
using namespace linelet::test;

namespace {

using Method = ScreenNormalMethod;
constexpr Method methods[] = {Method::LocalDerivatives,
                              Method::PlaneDiagonals,
                              Method::PlaneCircle,
                              Method::Tensor};
const Eigen::Vector3f eye = Eigen::Vector3f::Zero();

const Surface tilted = [](const Point& ray) {
  return plane(ray, Point(0.4, -0.3, -0.85).normalized(), -5);
};
const Surface ball = [](const Point& ray) {
  return sphere(ray, Point(0.3, -0.2, 6), 2.2);
};
const Surface column = [](const Point& ray) { return cylinder(ray, 6, 2); };
/// Two planes that meet in an edge.
const Surface roof = [](const Point& ray) {
  const Point side = Point(ray.x() < 0 ? -0.6 : 0.6, 0, -0.8);
  return plane(ray, side, -4);
};

TEST(ScreenNormals, OfPlanesWithoutNoiseAreTheirs)
{
  for (const Method method : methods)
    for (const unsigned samples : {5U, 9U, 17U, 25U})
      for (const int layers : {1, 8}) {
        const DepthPicture picture(96, 64, layers, tilted);
        const double error = picture.meanError(
            screenNormals(picture.samples, eye, normalsBy(method, samples)));
        EXPECT_LT(error, method == Method::Tensor ? 0.1 : 0.5)
            << nameOf(method) << " " << samples << " x " << layers;
      }
}

TEST(ScreenNormals, OfCurvedSurfacesWithoutNoiseAreWithinADegreeOrTwo)
{
  for (const Method method : methods)
    for (const Surface& surface : {ball, column}) {
      const DepthPicture picture(160, 120, 1, surface);
      EXPECT_LT(
          picture.meanError(screenNormals(picture.samples, eye, normalsBy(method))), 2)
          << nameOf(method);
    }
}

TEST(ScreenNormals, UnderNoiseAreBestByDiagonalsAndTensorAndWorstByDerivatives)
{
  constexpr unsigned seed = 5;
  SCOPED_TRACE(seed);
  const struct {
    const char* name;
    Surface surface;
  } scenes[] = {
      {"plane", tilted}, {"sphere", ball}, {"cylinder", column}, {"roof", roof}};
  for (const auto& scene : scenes)
    for (const int layers : {1, 8}) {
      // A third of the distance between pixels.
      const DepthPicture picture(160, 120, layers, scene.surface, 0.01, seed);
      const auto error = [&](Method method) {
        return picture.meanError(
            screenNormals(picture.samples, eye, normalsBy(method)));
      };
      const double ld = error(Method::LocalDerivatives),
                   pc = error(Method::PlaneCircle), pd = error(Method::PlaneDiagonals),
                   ti = error(Method::Tensor);
      SCOPED_TRACE(std::string(scene.name) + ", " + std::to_string(layers) +
                   " layers: " + std::to_string(ld) + " " + std::to_string(pc) + " " +
                   std::to_string(pd) + " " + std::to_string(ti));
      // The figure of an independent simulation: the diagonals are the least-squares
      // slope, while the tensor gives near samples more weight.
      EXPECT_GT(ld, 2 * pc);
      EXPECT_GT(ld, 2 * ti);
      EXPECT_GT(pc, ti);
      EXPECT_LT(ti, 1.2 * pd);
    }
}

TEST(ScreenNormals, WithADistanceLimitRankAsInThePublication)
{
  // Two noisy planes of points, seen at a slant, as in its Fig. 6.
  constexpr unsigned seed = 9;
  SCOPED_TRACE(seed);
  boost::random::mt19937 random(seed);
  boost::random::uniform_real_distribution<double> uniform(-1.5, 1.5);
  boost::random::normal_distribution<double> noise(0, 0.01);
  constexpr double slope = 0.7;
  Points points;
  for (int i = 0; i < 75000; ++i) {
    const double x = uniform(random), y = uniform(random);
    const double dx = noise(random), dy = noise(random), dz = noise(random);
    points.emplace_back(x + dx, y + dy, dz - slope * std::abs(x));
  }
  Camera camera;
  camera.lookAt(Point(0.2, -4.3, 2.1), Point(0, 0, -0.4));
  camera.width = 320;
  camera.height = 240;
  DepthPicture picture(camera.width, camera.height, 1, tilted);
  picture.samples = sampleLayers(points, camera, 3);
  for (std::size_t k = 0; k < picture.truth.size(); ++k) {
    const Index point = picture.samples.point[k];
    if (point != SampleLayers::nothing)
      picture.truth[k] =
          Point(points[point].x() < 0 ? -slope : slope, 0, 1).normalized();
    else
      picture.truth[k].setConstant(std::numeric_limits<double>::quiet_NaN());
  }
  const auto error = [&](Method method) {
    ScreenNormalSettings settings = normalsBy(method);
    settings.max_distance = 0.1;
    const Point from = camera.eye - picture.samples.origin;
    return picture.meanError(
        screenNormals(picture.samples, from.cast<float>(), settings));
  };
  const double ld = error(Method::LocalDerivatives), pc = error(Method::PlaneCircle),
               pd = error(Method::PlaneDiagonals), ti = error(Method::Tensor);
  EXPECT_GT(ld, pc);
  EXPECT_GT(pc, pd);
  EXPECT_GT(pd, ti);
  SCOPED_TRACE(std::to_string(ld) + " " + std::to_string(pc) + " " +
               std::to_string(pd) + " " + std::to_string(ti));
  EXPECT_GT(pd, 1.2 * ti);
}

TEST(ScreenNormals, OfTensorsFollowTheFormula)
{
  // The smallest eigenvector of sum d (x) d / |d| over the 8 samples of the surrounding
  // pixels, with d from the mean of the pixel's own samples.
  constexpr unsigned seed = 8;
  SCOPED_TRACE(seed);
  constexpr int layers = 8;
  const DepthPicture picture(40, 30, layers, roof, 0.01, seed);
  const SampleLayers& samples = picture.samples;
  const auto at = [&](int column, int row, int layer) {
    const std::size_t k = samples.at(column, row, layer);
    return Point(samples.x[k], samples.y[k], samples.z[k]);
  };
  const NormalImage normals = screenNormals(samples, eye, normalsBy(Method::Tensor, 9));
  for (int row = 2; row < 28; ++row)
    for (int column = 2; column < 38; ++column) {
      Point center = Point::Zero();
      for (int layer = 0; layer < layers; ++layer)
        center += at(column, row, layer) / layers;
      SymmetricTensor tensor;
      for (const int reach : {1, 2})
        for (const int across : {-reach, reach})
          for (const int down : {-reach, reach})
            for (int layer = 0; layer < layers; ++layer) {
              const Point d = at(column + across, row + down, layer) - center;
              tensor.add(1 / d.norm(), d);
            }
      const std::size_t k = samples.at(column, row);
      const Point n(normals.x[k], normals.y[k], normals.z[k]);
      EXPECT_GT(std::abs(n.dot(eigenAnalysis(tensor).normal())), 0.999999);
    }
}

TEST(ScreenNormals, SmoothingLowersTheErrorUnderNoise)
{
  const DepthPicture picture(160, 120, 1, tilted, 0.02, 6);
  ScreenNormalSettings settings = normalsBy(Method::Tensor);
  double before = 1e9;
  for (const unsigned passes : {0U, 1U, 3U}) {
    settings.smoothing = passes;
    const double error =
        picture.meanError(screenNormals(picture.samples, eye, settings));
    EXPECT_LT(error, 0.85 * before);
    before = error;
  }
}

TEST(ScreenNormals, TheDistanceLimitKeepsStepsApart)
{
  const Surface step = [](const Point& ray) {
    return plane(ray, Point(0, 0, -1), ray.x() < 0 ? -4 : -6);
  };
  const DepthPicture picture(80, 60, 1, step);
  for (const Method method :
       {Method::PlaneDiagonals, Method::PlaneCircle, Method::Tensor}) {
    ScreenNormalSettings settings = normalsBy(method);
    const double without =
        picture.meanError(screenNormals(picture.samples, eye, settings));
    settings.max_distance = 0.5;
    const double with =
        picture.meanError(screenNormals(picture.samples, eye, settings));
    EXPECT_GT(without, 1) << nameOf(method);
    EXPECT_LT(with, 0.1) << nameOf(method);
  }
}

TEST(ScreenNormals, AreUnitVectorsTowardTheEyeForAnyNumberOfThreads)
{
  const DepthPicture picture(101, 57, 8, ball, 0.01, 7);
  for (const Method method : methods) {
    ScreenNormalSettings settings = normalsBy(method, 17);
    settings.smoothing = 1;
    settings.threads = 1;
    const NormalImage one = screenNormals(picture.samples, eye, settings);
    settings.threads = 5;
    const NormalImage many = screenNormals(picture.samples, eye, settings);
    for (std::size_t k = 0; k < one.x.size(); ++k) {
      if (std::isnan(one.x[k])) {
        EXPECT_TRUE(std::isnan(many.x[k]));
        continue;
      }
      EXPECT_EQ(one.x[k], many.x[k]);
      EXPECT_EQ(one.y[k], many.y[k]);
      EXPECT_EQ(one.z[k], many.z[k]);
      const Eigen::Vector3f n(one.x[k], one.y[k], one.z[k]);
      EXPECT_NEAR(n.norm(), 1, 1e-5);
    }
  }
}

TEST(ScreenNormals, AreNaNWhereNothingIsSeen)
{
  const Surface nothing = [](const Point&) { return Hit(); };
  const DepthPicture empty(20, 10, 2, nothing);
  DepthPicture lonely(20, 10, 1, nothing);
  const std::size_t k = lonely.samples.at(7, 4);
  lonely.samples.x[k] = lonely.samples.y[k] = lonely.samples.z[k] = 1;
  DepthPicture coincident(20, 10, 1, tilted);
  for (auto* values :
       {&coincident.samples.x, &coincident.samples.y, &coincident.samples.z})
    values->assign(values->size(), 3.F);
  for (const Method method : methods)
    for (const DepthPicture& picture : {empty, lonely, coincident})
      for (const float value :
           screenNormals(picture.samples, eye, normalsBy(method, 25)).x)
        EXPECT_TRUE(std::isnan(value)) << nameOf(method);
  SampleLayers none;
  EXPECT_TRUE(screenNormals(none, eye, {}).x.empty());
}

TEST(ScreenNormals, RefuseInvalidSettings)
{
  const DepthPicture picture(8, 8, 1, tilted);
  ScreenNormalSettings settings;
  settings.samples = 7;
  EXPECT_THROW(screenNormals(picture.samples, eye, settings), std::invalid_argument);
  settings.samples = 9;
  settings.max_distance = -1;
  EXPECT_THROW(screenNormals(picture.samples, eye, settings), std::invalid_argument);
}

} // namespace
