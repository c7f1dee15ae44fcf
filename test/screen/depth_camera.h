// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>
#include <functional>
#include <limits>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>

#include <linelet/screen/screen_normals.h>

namespace linelet::test {

/** \brief Where a ray from the origin hits something: the distance along it, and the
 * normal. */
struct Hit {
  double distance = std::numeric_limits<double>::quiet_NaN();
  Point normal = Point::Zero();
};

using Surface = std::function<Hit(const Point& ray)>;

inline Hit
plane(const Point& ray, const Point& normal, double offset)
{
  const double distance = offset / ray.dot(normal);
  return distance > 0 ? Hit{distance, normal} : Hit{};
}

inline Hit
sphere(const Point& ray, const Point& center, double radius)
{
  const double b = ray.dot(center) / ray.squaredNorm();
  const double c = (center.squaredNorm() - radius * radius) / ray.squaredNorm();
  if (b * b < c)
    return {};
  const double distance = b - std::sqrt(b * b - c);
  return {distance, (ray * distance - center) / radius};
}

/** \brief Upright, around x = 0, z = depth. */
inline Hit
cylinder(const Point& ray, double depth, double radius)
{
  Point flat = ray;
  flat.y() = 0;
  const Hit hit = sphere(flat, Point(0, 0, depth), radius);
  return hit;
}

/** \brief A picture of a surface by a camera at the origin that looks along z, with
 * noise along the rays, and the true normals facing the camera. */
struct DepthPicture {
  SampleLayers samples;
  Points truth; // of every pixel; NaN where nothing is seen

  DepthPicture(int width,
               int height,
               int layers,
               const Surface& surface,
               double noise = 0,
               unsigned seed = 1)
  {
    boost::random::mt19937 random(seed);
    boost::random::normal_distribution<double> normal(0, 1);
    samples.width = width;
    samples.height = height;
    samples.layers = layers;
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    truth.assign(static_cast<std::size_t>(width * height), Point(nan, nan, nan));
    for (int layer = 0; layer < layers; ++layer)
      for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column) {
          const double part = layers > 1 ? (layer + 0.5) / layers : 0.5;
          const double other = layers > 1 ? ((3 * layer) % layers + 0.5) / layers : 0.5;
          const Point ray((column + part - width / 2.0) / width,
                          (row + other - height / 2.0) / width,
                          1);
          const Hit hit = surface(ray);
          const Point at = ray * (hit.distance + noise * normal(random));
          samples.x.push_back(static_cast<float>(at.x()));
          samples.y.push_back(static_cast<float>(at.y()));
          samples.z.push_back(static_cast<float>(at.z()));
          if (std::isfinite(hit.distance) && layer == 0)
            truth[samples.at(column, row)] =
                hit.normal.dot(ray) > 0 ? Point(-hit.normal) : hit.normal;
        }
  }

  /** \brief Mean angle to the truth in degrees, over the pixels that have both. */
  double
  meanError(const NormalImage& normals, int border = 4) const
  {
    double sum = 0;
    std::size_t count = 0;
    for (int row = border; row < samples.height - border; ++row)
      for (int column = border; column < samples.width - border; ++column) {
        const std::size_t k = samples.at(column, row);
        const Point n(normals.x[k], normals.y[k], normals.z[k]);
        if (!truth[k].allFinite() || !n.allFinite())
          continue;
        sum += std::acos(std::min(1.0, std::max(-1.0, n.dot(truth[k]))));
        ++count;
      }
    return sum / static_cast<double>(count) * 180 / M_PI;
  }
};

inline ScreenNormalSettings
normalsBy(ScreenNormalMethod method, unsigned samples = 9)
{
  ScreenNormalSettings settings;
  settings.method = method;
  settings.samples = samples;
  return settings;
}

} // namespace linelet::test
