// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/screen/screen_normals.h>

#include <algorithm>
#include <cstddef>

#include <linelet/support/threads.h>

#include "normal_kernels.h"
#include "normal_passes.h"

namespace linelet {

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
  screen::smooth(pixels, settings, image, threads);
  return image;
}

} // namespace linelet
