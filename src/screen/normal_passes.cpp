// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "normal_passes.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>

#include "support/huge_pages.h"

namespace linelet::screen {

namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

/** \brief The squared distance limit of samples. */
float
limitOf(double max_distance)
{
  const auto distance = static_cast<float>(max_distance);
  return distance > 0 ? distance * distance : std::numeric_limits<float>::infinity();
}

/** \brief Copies a row of a picture into a padded one; NaN around it, and in rows
 * beyond the picture. */
void
padRow(const float* from, const PaddedSamples& sizes, bool inside, float* to)
{
  float* const begin = std::fill_n(to, PaddedSamples::margin, nan);
  float* const end = inside ? std::copy_n(from, sizes.width, begin) : begin;
  std::fill(end, to + sizes.stride, nan);
}

} // namespace

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
  const auto size = static_cast<std::size_t>(out.layer);
  const auto make = [](UninitializedVector<float>& values, std::size_t count) {
    reserveHuge(values, count);
    values.resize(count);
  };
  for (auto* values : {&out.x, &out.y, &out.z})
    make(*values, size * static_cast<std::size_t>(samples.layers));
  for (auto* values : {&out.cx, &out.cy, &out.cz})
    make(*values, size);
  const float limit = limitOf(max_distance);
  const NormalKernels kernels = normalKernels();
#pragma omp parallel for num_threads(threads)
  for (int row = -PaddedSamples::margin; row < samples.height + PaddedSamples::margin;
       ++row) {
    const bool inside = row >= 0 && row < samples.height;
    const std::ptrdiff_t begin = out.at(-PaddedSamples::margin, row);
    for (int layer = 0; layer < samples.layers; ++layer) {
      const std::size_t from = inside ? samples.at(0, row, layer) : 0;
      const std::ptrdiff_t to = layer * out.layer + begin;
      padRow(samples.x.data() + from, out, inside, out.x.data() + to);
      padRow(samples.y.data() + from, out, inside, out.y.data() + to);
      padRow(samples.z.data() + from, out, inside, out.z.data() + to);
    }
    for (auto* values : {&out.cx, &out.cy, &out.cz})
      std::fill_n(values->begin() + begin, out.stride, nan);
    for (int column = 0; inside && column < samples.width; column += block)
      kernels.positions(out, limit, column, row);
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
  for (auto* values : {&image.x, &image.y, &image.z}) {
    reserveHuge(*values, size);
    values->assign(size, nan);
  }
  return image;
}

void
turnToEye(const PaddedSamples& samples,
          const Eigen::Vector3f& eye,
          NormalImage& image,
          int threads)
{
  const float ex = eye.x(), ey = eye.y(), ez = eye.z();
#pragma omp parallel for num_threads(threads)
  for (int row = 0; row < image.height; ++row) {
    const std::ptrdiff_t from = samples.at(0, row),
                         to = std::ptrdiff_t{row} * image.width;
    const float *cx = samples.cx.data() + from, *cy = samples.cy.data() + from,
                *cz = samples.cz.data() + from;
    float *x = image.x.data() + to, *y = image.y.data() + to, *z = image.z.data() + to;
    for (int column = 0; column < image.width; ++column) {
      const float away =
          (x[column] * (ex - cx[column]) + y[column] * (ey - cy[column])) +
          z[column] * (ez - cz[column]);
      const float turn = away < 0 ? -1 : 1;
      x[column] *= turn;
      y[column] *= turn;
      z[column] *= turn;
    }
  }
}

void
smooth(const PaddedSamples& samples,
       const ScreenNormalSettings& settings,
       NormalImage& image,
       int threads)
{
  if (settings.smoothing == 0)
    return;
  PaddedNormals normals, next;
  for (PaddedNormals* each : {&normals, &next})
    for (auto* values : {&each->x, &each->y, &each->z}) {
      reserveHuge(*values, samples.cx.size());
      values->resize(samples.cx.size());
    }
  const int width = image.width, height = image.height;
  const auto place = [&](int row) { return std::ptrdiff_t{row} * width; };
#pragma omp parallel for num_threads(threads)
  for (int row = -PaddedSamples::margin; row < height + PaddedSamples::margin; ++row) {
    const bool inside = row >= 0 && row < height;
    const std::ptrdiff_t from = inside ? place(row) : 0,
                         to = samples.at(-PaddedSamples::margin, row);
    for (PaddedNormals* each : {&normals, &next}) {
      padRow(image.x.data() + from, samples, inside, each->x.data() + to);
      padRow(image.y.data() + from, samples, inside, each->y.data() + to);
      padRow(image.z.data() + from, samples, inside, each->z.data() + to);
    }
  }
  const float limit = limitOf(settings.max_distance);
  const NormalKernels kernels = normalKernels();
  for (unsigned pass = 0; pass < settings.smoothing; ++pass) {
#pragma omp parallel for num_threads(threads)
    for (int row = 0; row < height; ++row)
      for (int column = 0; column < width; column += block)
        kernels.smooth(samples, normals, limit, column, row, next);
    std::swap(normals, next);
  }
#pragma omp parallel for num_threads(threads)
  for (int row = 0; row < height; ++row) {
    const std::ptrdiff_t from = samples.at(0, row);
    std::copy_n(normals.x.begin() + from, width, image.x.begin() + place(row));
    std::copy_n(normals.y.begin() + from, width, image.y.begin() + place(row));
    std::copy_n(normals.z.begin() + from, width, image.z.begin() + place(row));
  }
}

} // namespace linelet::screen
