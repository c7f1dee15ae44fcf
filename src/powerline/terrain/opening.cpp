// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/terrain/opening.h"

#include <cstddef>

#include <linelet/support/threads.h>

#include "support/parallel_failure.h"

namespace linelet::powerline {

namespace {

// Sliding minimum (or maximum, by sign) along one line of cells, any radius, O(length).
void
slide(
    const float* in, float* out, int count, std::size_t stride, int radius, float sign)
{
  std::vector<int> queue(static_cast<std::size_t>(count));
  std::size_t head = 0, tail = 0;
  const auto value = [&](int i) {
    return sign * in[static_cast<std::size_t>(i) * stride];
  };
  for (int i = 0, next = 0; i < count; ++i) {
    for (; next < count && next <= i + radius; ++next) {
      while (tail > head && value(queue[tail - 1]) >= value(next))
        --tail;
      queue[tail++] = next;
    }
    while (queue[head] < i - radius)
      ++head;
    out[static_cast<std::size_t>(i) * stride] = sign * value(queue[head]);
  }
}

std::vector<float>
filtered(const std::vector<float>& raster,
         int columns,
         int rows,
         int radius,
         float sign,
         unsigned threads)
{
  std::vector<float> half(raster.size()), out(raster.size());
  const auto width = static_cast<std::size_t>(columns);
  ParallelFailure failure;
#pragma omp parallel num_threads(threadCount(threads))
  {
#pragma omp for schedule(static)
    for (int r = 0; r < rows; ++r)
      failure.guard([&] {
        const std::size_t begin = static_cast<std::size_t>(r) * width;
        slide(&raster[begin], &half[begin], columns, 1, radius, sign);
      });
#pragma omp for schedule(static)
    for (std::size_t c = 0; c < width; ++c)
      failure.guard([&] { slide(&half[c], &out[c], rows, width, radius, sign); });
  }
  failure.rethrow();
  return out;
}

} // namespace

std::vector<float>
openRaster(const std::vector<float>& raster,
           int columns,
           int rows,
           int radius,
           unsigned threads)
{
  return filtered(filtered(raster, columns, rows, radius, 1, threads),
                  columns,
                  rows,
                  radius,
                  -1,
                  threads);
}

} // namespace linelet::powerline
