// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/screen/screen_normals.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include <linelet/support/text.h>
#include <linelet/support/threads.h>

#include "normal_kernels.h"
#include "normal_passes.h"

namespace linelet {

void
validate(const ScreenNormalSettings& settings)
{
  if (settings.samples != 5 && settings.samples != 9 && settings.samples != 17 &&
      settings.samples != 25)
    throw std::invalid_argument("samples of a normal must be 5, 9, 17 or 25, not " +
                                std::to_string(settings.samples));
  if (!(settings.max_distance >= 0))
    throw std::invalid_argument("the distance limit " + textOf(settings.max_distance) +
                                " of normals is negative");
}

namespace screen {

PaddedSamples
padded(const SampleLayers& samples, double max_distance, int threads)
{
  PaddedSamples out;
  out.width = samples.width;
  out.height = samples.height;
  out.layers = samples.layers;
  // Blocks may reach beyond the last column.
  out.stride = samples.width + block + 2 * PaddedSamples::margin;
  out.layer = out.stride * (samples.height + 2 * PaddedSamples::margin);
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  const auto size = static_cast<std::size_t>(out.layer);
  const auto all = size * static_cast<std::size_t>(samples.layers);
  for (auto* values : {&out.x, &out.y, &out.z})
    values->assign(all, nan);
  for (auto* values : {&out.cx, &out.cy, &out.cz})
    values->assign(size, nan);
  const auto distance = static_cast<float>(max_distance);
  const float limit =
      distance > 0 ? distance * distance : std::numeric_limits<float>::infinity();
#pragma omp parallel for num_threads(threads)
  for (int row = 0; row < samples.height; ++row) {
    for (int layer = 0; layer < samples.layers; ++layer) {
      const auto from = static_cast<std::ptrdiff_t>(samples.at(0, row, layer));
      const std::ptrdiff_t to = layer * out.layer + out.at(0, row);
      std::copy_n(samples.x.begin() + from, samples.width, out.x.begin() + to);
      std::copy_n(samples.y.begin() + from, samples.width, out.y.begin() + to);
      std::copy_n(samples.z.begin() + from, samples.width, out.z.begin() + to);
    }
    for (int column = 0; column < samples.width; ++column) {
      float x = 0, y = 0, z = 0, fx = 0, fy = 0, fz = 0;
      int count = 0;
      for (int layer = 0; layer < samples.layers; ++layer) {
        const std::size_t k = samples.at(column, row, layer);
        if (!std::isfinite(samples.x[k]) || !std::isfinite(samples.y[k]) ||
            !std::isfinite(samples.z[k]))
          continue;
        if (count == 0) {
          fx = samples.x[k];
          fy = samples.y[k];
          fz = samples.z[k];
        }
        const float dx = samples.x[k] - fx, dy = samples.y[k] - fy,
                    dz = samples.z[k] - fz;
        if ((dx * dx + dy * dy) + dz * dz > limit)
          continue;
        x += dx;
        y += dy;
        z += dz;
        ++count;
      }
      if (count == 0)
        continue;
      const auto k = static_cast<std::size_t>(out.at(column, row));
      out.cx[k] = fx + x / static_cast<float>(count);
      out.cy[k] = fy + y / static_cast<float>(count);
      out.cz[k] = fz + z / static_cast<float>(count);
    }
  }
  return out;
}

NormalImage
emptyImage(const PaddedSamples& samples)
{
  NormalImage image;
  image.width = samples.width;
  image.height = samples.height;
  const auto size = static_cast<std::size_t>(samples.width) *
                    static_cast<std::size_t>(samples.height);
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  for (auto* values : {&image.x, &image.y, &image.z})
    values->assign(size, nan);
  return image;
}

void
turnToEye(const PaddedSamples& samples,
          const Eigen::Vector3f& eye,
          NormalImage& image,
          int threads)
{
#pragma omp parallel for num_threads(threads)
  for (int row = 0; row < image.height; ++row)
    for (int column = 0; column < image.width; ++column) {
      const auto k = static_cast<std::size_t>(samples.at(column, row));
      const auto n =
          static_cast<std::size_t>(row) * static_cast<std::size_t>(image.width) +
          static_cast<std::size_t>(column);
      const float away = (image.x[n] * (eye.x() - samples.cx[k]) +
                          image.y[n] * (eye.y() - samples.cy[k])) +
                         image.z[n] * (eye.z() - samples.cz[k]);
      if (away < 0) {
        image.x[n] = -image.x[n];
        image.y[n] = -image.y[n];
        image.z[n] = -image.z[n];
      }
    }
}

NormalImage
smoothed(const PaddedSamples& samples,
         const NormalImage& image,
         double max_distance,
         int threads)
{
  NormalImage out = image;
  const auto distance = static_cast<float>(max_distance);
  const float limit =
      distance > 0 ? distance * distance : std::numeric_limits<float>::infinity();
  const auto place = [&](int column, int row) {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(image.width) +
           static_cast<std::size_t>(column);
  };
#pragma omp parallel for num_threads(threads)
  for (int row = 0; row < image.height; ++row)
    for (int column = 0; column < image.width; ++column) {
      const std::size_t here = place(column, row);
      if (std::isnan(image.x[here]))
        continue;
      const auto c = static_cast<std::size_t>(samples.at(column, row));
      float x = 0, y = 0, z = 0;
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) {
          const int u = column + dx, v = row + dy;
          if (u < 0 || v < 0 || u >= image.width || v >= image.height)
            continue;
          const std::size_t there = place(u, v);
          const auto k = static_cast<std::size_t>(samples.at(u, v));
          const float px = samples.cx[k] - samples.cx[c],
                      py = samples.cy[k] - samples.cy[c],
                      pz = samples.cz[k] - samples.cz[c];
          if (std::isnan(image.x[there]) || !((px * px + py * py) + pz * pz <= limit))
            continue;
          // 4 in the middle, 2 beside, 1 at the corners.
          const auto weight =
              static_cast<float>((2 - std::abs(dx)) * (2 - std::abs(dy)));
          x += weight * image.x[there];
          y += weight * image.y[there];
          z += weight * image.z[there];
        }
      const float length = std::sqrt((x * x + y * y) + z * z);
      if (!(length > 0))
        continue;
      out.x[here] = x / length;
      out.y[here] = y / length;
      out.z[here] = z / length;
    }
  return out;
}

} // namespace screen

NormalImage
screenNormals(const SampleLayers& samples,
              const Eigen::Vector3f& eye,
              const ScreenNormalSettings& settings)
{
  validate(settings);
  const int threads = threadCount(settings.threads);
  const screen::PaddedSamples pixels =
      screen::padded(samples, settings.max_distance, threads);
  NormalImage image = screen::emptyImage(pixels);
  const screen::NormalKernels kernels = screen::normalKernels();
#pragma omp parallel for num_threads(threads) schedule(dynamic, 8)
  for (int row = 0; row < samples.height; ++row)
    for (int column = 0; column < samples.width; column += screen::block) {
      screen::NormalBlock normals;
      kernels.normals(pixels, settings, column, row, normals);
      const int count = std::min(screen::block, samples.width - column);
      const auto to = static_cast<std::ptrdiff_t>(samples.at(column, row));
      std::copy_n(normals.x, count, image.x.begin() + to);
      std::copy_n(normals.y, count, image.y.begin() + to);
      std::copy_n(normals.z, count, image.z.begin() + to);
    }
  screen::turnToEye(pixels, eye, image, threads);
  for (unsigned pass = 0; pass < settings.smoothing; ++pass)
    image = screen::smoothed(pixels, image, settings.max_distance, threads);
  return image;
}

} // namespace linelet
