// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/screen/sample_layers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

#include <linelet/support/text.h>
#include <linelet/support/threads.h>

namespace linelet {

namespace {

struct Place {
  double x, y;
};

/** \brief Standard positions of 1, 2, 4 and 8 samples in a pixel, in sixteenths from
 * its center (as in Direct3D and Vulkan). */
std::vector<Place>
placesOf(int layers)
{
  switch (layers) {
  case 1:
    return {{0, 0}};
  case 2:
    return {{4, 4}, {-4, -4}};
  case 4:
    return {{-2, -6}, {6, -2}, {-6, 2}, {2, 6}};
  case 8:
    return {{1, -3}, {-1, 3}, {5, 1}, {-3, -5}, {-5, 5}, {-7, -1}, {3, 7}, {7, -7}};
  default:
    throw std::invalid_argument("samples per pixel must be 1, 2, 4 or 8, not " +
                                std::to_string(layers));
  }
}

/** \brief A projected point. */
struct Spot {
  float x, y, depth, radius;
};

std::vector<Spot>
project(const Points& points,
        const Camera& camera,
        double point_size,
        double diameter,
        int threads)
{
  std::vector<Spot> spots(points.size());
#pragma omp parallel for num_threads(threads)
  for (std::ptrdiff_t k = 0; k < static_cast<std::ptrdiff_t>(points.size()); ++k) {
    const auto i = static_cast<std::size_t>(k);
    const Point at = camera.project(points[i]);
    const bool seen = at.allFinite() && at.z() >= camera.near && at.z() <= camera.far &&
                      (at.z() > 0 || !camera.perspective());
    const double scale = camera.focalLength() / (camera.perspective() ? at.z() : 1);
    const double radius = std::max(point_size, diameter * scale) / 2;
    spots[i] = {static_cast<float>(at.x()),
                static_cast<float>(at.y()),
                static_cast<float>(at.z()),
                seen ? static_cast<float>(radius) : -1};
  }
  return spots;
}

/** \brief The middle of the finite points. */
Point
middleOf(const Points& points)
{
  Point low = Point::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const Point& p : points)
    if (p.allFinite()) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
  return low.x() <= high.x() ? Point((low + high) / 2) : Point::Zero();
}

} // namespace

SampleLayers
sampleLayers(const Points& points,
             const Camera& camera,
             double point_size,
             double diameter,
             int layers,
             unsigned threads)
{
  const std::vector<Place> places = placesOf(layers);
  if (!(point_size > 0) && !(diameter > 0))
    throw std::invalid_argument("point size " + textOf(point_size) +
                                " is not positive");
  if (camera.width < 1 || camera.height < 1)
    throw std::invalid_argument("a picture needs at least one pixel");
  const int count = threadCount(threads);
  const std::vector<Spot> spots = project(points, camera, point_size, diameter, count);

  SampleLayers out;
  out.width = camera.width;
  out.height = camera.height;
  out.layers = layers;
  out.origin = middleOf(points);
  const std::size_t size = out.at(0, 0, layers);
  std::vector<float> depth(size, std::numeric_limits<float>::infinity());
  out.point.assign(size, SampleLayers::nothing);
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  out.x.assign(size, nan);
  out.y.assign(size, nan);
  out.z.assign(size, nan);

  // One thread per band of rows.
#pragma omp parallel for num_threads(count) schedule(static, 1)
  for (int band = 0; band < count; ++band) {
    const auto row = [&](int number) {
      return static_cast<int>(std::int64_t{camera.height} * number / count);
    };
    const int begin = row(band), end = row(band + 1);
    for (std::size_t i = 0; i < spots.size(); ++i) {
      const Spot& spot = spots[i];
      if (spot.radius < 0 || !(spot.y + spot.radius >= static_cast<float>(begin)) ||
          !(spot.y - spot.radius <= static_cast<float>(end)) ||
          !(spot.x + spot.radius >= 0) ||
          !(spot.x - spot.radius <= static_cast<float>(camera.width)))
        continue;
      const auto first = [](float value, int least) {
        return std::max(least, static_cast<int>(value));
      };
      const int right =
          std::min(camera.width - 1, static_cast<int>(spot.x + spot.radius));
      const int bottom = std::min(end - 1, static_cast<int>(spot.y + spot.radius));
      const float square = spot.radius * spot.radius;
      for (int y = first(spot.y - spot.radius, begin); y <= bottom; ++y)
        for (int x = first(spot.x - spot.radius, 0); x <= right; ++x)
          for (int layer = 0; layer < layers; ++layer) {
            const Place& place = places[static_cast<std::size_t>(layer)];
            const float dx = static_cast<float>(x + 0.5 + place.x / 16) - spot.x;
            const float dy = static_cast<float>(y + 0.5 + place.y / 16) - spot.y;
            const std::size_t sample = out.at(x, y, layer);
            if (dx * dx + dy * dy <= square && spot.depth < depth[sample]) {
              depth[sample] = spot.depth;
              out.point[sample] = static_cast<Index>(i);
            }
          }
    }
    for (int layer = 0; layer < layers; ++layer)
      for (int y = begin; y < end; ++y)
        for (int x = 0; x < camera.width; ++x) {
          const std::size_t sample = out.at(x, y, layer);
          if (out.point[sample] == SampleLayers::nothing)
            continue;
          const Place& place = places[static_cast<std::size_t>(layer)];
          // The depth of the point itself, in double.
          const double z =
              camera.axes.row(2).dot(points[out.point[sample]] - camera.eye);
          const Eigen::Vector3f at =
              (camera.unproject(
                   Point(x + 0.5 + place.x / 16, y + 0.5 + place.y / 16, z)) -
               out.origin)
                  .cast<float>();
          out.x[sample] = at.x();
          out.y[sample] = at.y();
          out.z[sample] = at.z();
        }
  }
  return out;
}

} // namespace linelet
