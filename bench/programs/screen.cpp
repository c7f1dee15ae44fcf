// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// Screen-space normals compared with pcl::IntegralImageNormalEstimation, and tensor
// splats.
//   benchmark_screen [POINTS]
//
// Organized clouds of 640 x 480 with noise along the rays; a roof of noisy points from
// several sides; a picture of 1600 x 1200 with 8 samples per pixel; POINTS splats
// (1e6). The fastest of three repetitions counts.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <boost/random/uniform_real_distribution.hpp>

// The feature's templates are instantiated here: its library would bring VTK and MPI.
#define PCL_NO_PRECOMPILE
#include <pcl/features/impl/integral_image_normal.hpp>
#include <pcl/features/integral_image_normal.h>

#include <linelet/screen/screen_space_normal_estimation.h>
#include <linelet/screen/tensor_splats.h>

#include "best_time.h"

using namespace linelet;

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

constexpr ScreenNormalMethod methods[] = {ScreenNormalMethod::LocalDerivatives,
                                          ScreenNormalMethod::PlaneCircle,
                                          ScreenNormalMethod::PlaneDiagonals,
                                          ScreenNormalMethod::Tensor};

/** \brief Angle between unit vectors, in degrees. */
double
angleBetween(const Point& a, const Point& b)
{
  return std::acos(std::clamp(a.dot(b), -1.0, 1.0)) * 180 / M_PI;
}

template <class Work>
bench::BestTime
fastest(const Work& work)
{
  bench::BestTime best;
  for (int repetition = 0; repetition < 3; ++repetition)
    best.run(work);
  return best;
}

/** \brief Distance along a ray and normal: a plane, or a ball in front of it. */
std::pair<double, Point>
hit(const Point& ray, bool curved)
{
  const Point normal = Point(0.4, -0.3, -0.85).normalized();
  const double far = -2 / ray.dot(normal);
  if (!curved)
    return {far, normal};
  const Point center(0.2, -0.1, 1.8);
  constexpr double radius = 0.5;
  const double b = ray.dot(center) / ray.squaredNorm();
  const double c = (center.squaredNorm() - radius * radius) / ray.squaredNorm();
  if (b * b < c)
    return {far, normal};
  const double near = b - std::sqrt(b * b - c);
  return {near, Point((ray * near - center) / radius)};
}

void
compareNormals(bool curved, double noise)
{
  constexpr int width = 640, height = 480;
  boost::random::mt19937 random(1);
  boost::random::normal_distribution<double> normal(0, noise);
  auto cloud = pcl::make_shared<Cloud>(width, height);
  Points truth;
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column) {
      const Point ray(
          (column - width / 2 + 0.5) / 525, (row - height / 2 + 0.5) / 525, 1);
      const auto [distance, n] = hit(ray, curved);
      truth.push_back(n.dot(ray) > 0 ? Point(-n) : n);
      const Point at = ray * (distance + normal(random));
      (*cloud)(column, row) = {static_cast<float>(at.x()),
                               static_cast<float>(at.y()),
                               static_cast<float>(at.z())};
    }
  const auto report = [&](const std::string& name,
                          const pcl::PointCloud<pcl::Normal>& normals,
                          const bench::BestTime& time) {
    double sum = 0;
    std::size_t known = 0, wrong = 0;
    for (std::size_t k = 0; k < normals.size(); ++k) {
      const Point n(normals[k].normal_x, normals[k].normal_y, normals[k].normal_z);
      if (!n.allFinite())
        continue;
      const double angle = angleBetween(n, truth[k]);
      sum += angle;
      wrong += angle > 30 ? 1 : 0;
      ++known;
    }
    std::printf("| %s, noise %g | %s | %.2f | %.2f | %.1f | %.1f | %.1f |\n",
                curved ? "ball and plane" : "plane",
                noise,
                name.c_str(),
                sum / static_cast<double>(known),
                100 * static_cast<double>(wrong) / static_cast<double>(known),
                100 * static_cast<double>(known) / static_cast<double>(normals.size()),
                1e3 * time.wall,
                1e3 * time.cpu);
    std::fflush(stdout);
  };
  pcl::PointCloud<pcl::Normal> normals;
  using Rival = pcl::IntegralImageNormalEstimation<pcl::PointXYZ, pcl::Normal>;
  const std::pair<Rival::NormalEstimationMethod, const char*> rivals[] = {
      {Rival::COVARIANCE_MATRIX, "pcl covariance matrix"},
      {Rival::AVERAGE_3D_GRADIENT, "pcl average 3D gradient"},
      {Rival::AVERAGE_DEPTH_CHANGE, "pcl average depth change"}};
  for (const auto& [method, name] : rivals) {
    const auto which = method;
    const bench::BestTime time = fastest([&] {
      Rival estimation;
      estimation.setNormalEstimationMethod(which);
      estimation.setMaxDepthChangeFactor(0.05F);
      estimation.setNormalSmoothingSize(10.F);
      estimation.setInputCloud(cloud);
      estimation.compute(normals);
    });
    report(name, normals, time);
  }
  for (const unsigned samples : {9U, 25U})
    for (const unsigned smoothing : {0U, 4U, 8U})
      for (const ScreenNormalMethod method : methods) {
        const bench::BestTime time = fastest([&] {
          ScreenSpaceNormalEstimation<pcl::PointXYZ> estimation;
          estimation.setMethod(method);
          estimation.setPattern(samples);
          estimation.setSmoothing(smoothing);
          estimation.setMaxDistance(0.1);
          estimation.setInputCloud(cloud);
          estimation.compute(normals);
        });
        report("linelet " + std::string(nameOf(method)) + ", " +
                   std::to_string(samples) + ", smoothed " + std::to_string(smoothing),
               normals,
               time);
      }
}

/** \brief Two planes of points as in Fig. 6 of the publication, seen from \a elevation
 * degrees above their eaves. */
void
noisyRoof(double noise, unsigned count, double elevation, double limit)
{
  constexpr int points_in_all = 300000;
  constexpr double slope = 0.7;
  boost::random::mt19937 random(3);
  boost::random::uniform_real_distribution<double> uniform(-1.5, 1.5);
  boost::random::normal_distribution<double> normal(0, 1);
  const auto shift = [&] { return noise * normal(random); };
  Points points;
  for (int i = 0; i < points_in_all; ++i) {
    const double x = uniform(random), y = uniform(random);
    points.emplace_back(x + shift(), y + shift(), shift() - slope * std::abs(x));
  }
  Camera camera;
  const double angle = elevation * M_PI / 180;
  camera.lookAt(Point(0.2, -5 * std::cos(angle), 5 * std::sin(angle) - 0.4),
                Point(0, 0, -0.4));
  camera.width = 640;
  camera.height = 480;
  const SampleLayers samples = sampleLayers(points, camera, 3);
  const Eigen::Vector3f eye = (camera.eye - samples.origin).cast<float>();
  for (const ScreenNormalMethod method : methods) {
    ScreenNormalSettings settings;
    settings.method = method;
    settings.samples = count;
    settings.max_distance = limit;
    const NormalImage normals = screenNormals(samples, eye, settings);
    double sum = 0;
    std::size_t known = 0, seen = 0;
    for (int row = 4; row < camera.height - 4; ++row)
      for (int column = 4; column < camera.width - 4; ++column) {
        const std::size_t k = samples.at(column, row);
        if (samples.point[k] == SampleLayers::nothing)
          continue;
        ++seen;
        const Point n(normals.x[k], normals.y[k], normals.z[k]);
        if (!n.allFinite())
          continue;
        ++known;
        const double side = points[samples.point[k]].x() < 0 ? -slope : slope;
        const Point truth = Point(side, 0, 1).normalized();
        sum += angleBetween(n, truth);
      }
    std::printf("| %g | %u | %g | %g | %s | %.2f | %.1f |\n",
                noise,
                count,
                elevation,
                limit,
                std::string(nameOf(method)).c_str(),
                sum / static_cast<double>(known),
                100 * static_cast<double>(known) / static_cast<double>(seen));
    std::fflush(stdout);
  }
}

void
noisyRoofs()
{
  std::printf(
      "| noise of a roof 3 wide | samples | seen from, degrees | distance limit "
      "| method | mean error, degrees | known, %% |\n|---|---|---|---|---|---|---|"
      "\n");
  for (const double noise : {0., 0.003, 0.01})
    for (const unsigned count : {9U, 25U})
      noisyRoof(noise, count, 60, 0);
  for (const double elevation : {60., 30., 15.})
    for (const double limit : {0.1, 0.05})
      noisyRoof(0.005, 9, elevation, limit);
}

void
largePicture()
{
  Camera camera;
  camera.lookAt(Point(0, -30, 25), Point(0, 0, 0));
  camera.width = 1600;
  camera.height = 1200;
  boost::random::mt19937 random(1);
  boost::random::uniform_real_distribution<double> uniform(-20, 20);
  Points points;
  for (int i = 0; i < 2000000; ++i) {
    const double x = uniform(random), y = uniform(random);
    points.emplace_back(x, y, std::sin(x) + std::cos(0.7 * y));
  }
  SampleLayers samples;
  const bench::BestTime splat =
      fastest([&] { samples = sampleLayers(points, camera, 3); });
  std::printf("1600 x 1200 x 8, 2e6 points: samples wall %.0f ms, CPU %.0f ms\n",
              1e3 * splat.wall,
              1e3 * splat.cpu);
  for (const unsigned count : {5U, 9U, 17U, 25U})
    for (const ScreenNormalMethod method : methods) {
      ScreenNormalSettings settings;
      settings.method = method;
      settings.samples = count;
      settings.max_distance = 1;
      const Eigen::Vector3f eye = (camera.eye - samples.origin).cast<float>();
      const bench::BestTime time =
          fastest([&] { screenNormals(samples, eye, settings); });
      std::printf("%u samples x 8, %s: wall %.0f ms, CPU %.0f ms\n",
                  count,
                  std::string(nameOf(method)).c_str(),
                  1e3 * time.wall,
                  1e3 * time.cpu);
      std::fflush(stdout);
    }
}

void
manySplats(std::size_t count)
{
  boost::random::mt19937 random(1);
  boost::random::uniform_real_distribution<double> uniform(-1, 1);
  Camera camera;
  camera.lookAt(Point(-3, -4, 2), Point(0, 0, 0));
  camera.width = 1200;
  camera.height = 760;
  camera.field_of_view = 40;
  std::vector<TensorGlyph> glyphs;
  while (glyphs.size() < count) {
    SymmetricTensor t;
    t.add(1, Point(uniform(random), uniform(random), uniform(random)));
    t.add(0.3, Point(uniform(random), uniform(random), uniform(random)));
    const EigenSystem system = eigenAnalysis(t);
    glyphs.push_back(glyphOf(Point(uniform(random), uniform(random), uniform(random)),
                             system,
                             shapeFactors(system.values),
                             0.02,
                             {{{0, 1, 0}, {1, 0, 0}, {0, 0, 1}}}));
  }
  const bench::BestTime splats = fastest([&] { drawSplats(glyphs, camera); });
  const bench::BestTime ellipsoids = fastest([&] { drawEllipsoids(glyphs, camera); });
  std::printf(
      "%zu splats of about 20 pixels: wall %.2f s, CPU %.2f s; ellipsoids: wall "
      "%.2f s, CPU %.2f s\n",
      count,
      splats.wall,
      splats.cpu,
      ellipsoids.wall,
      ellipsoids.cpu);
}

} // namespace

int
main(int argc, char** argv)
{
  std::printf(
      "| scene | method | mean error, degrees | above 30 degrees, %% | known, %% "
      "| wall ms | CPU ms |\n|---|---|---|---|---|---|---|\n");
  for (const bool curved : {false, true})
    for (const double noise : {0.002, 0.01})
      compareNormals(curved, noise);
  noisyRoofs();
  largePicture();
  manySplats(static_cast<std::size_t>(argc > 1 ? std::atof(argv[1]) : 1e6));
  return 0;
}
