// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include <linelet/screen/glyph_image.h>
#include <linelet/support/threads.h>

#include "glyph_footprint.h"

namespace linelet::screen {

/** \brief Draws opaque things; where they overlap, the nearest is visible.
 *
 * A thing has box(width, end), the pixels that it may cover above row end; and
 * depthAt(pixel), NaN outside it, and colorAt(pixel), both for pixel centers. */
template <class Thing>
GlyphImage
drawOpaque(const std::vector<Thing>& things, const Camera& camera, unsigned threads)
{
  GlyphImage image;
  image.width = camera.width;
  image.height = camera.height;
  image.pixels.resize(static_cast<std::size_t>(camera.width) *
                      static_cast<std::size_t>(camera.height));
  std::vector<double> depth(image.pixels.size(),
                            std::numeric_limits<double>::infinity());
  const int count = threadCount(threads);
  // Each band of rows is drawn by one thread; more of them balance the load.
  const int bands = std::min(4 * count, std::max(1, camera.height));
#pragma omp parallel for num_threads(count) schedule(dynamic, 1)
  for (int band = 0; band < bands; ++band) {
    const auto row = [&](int number) {
      return static_cast<int>(std::int64_t{camera.height} * number / bands);
    };
    for (const Thing& thing : things) {
      const PixelBox box = thing.box(image.width, row(band + 1));
      for (int y = std::max(box.top, row(band)); y <= box.bottom; ++y)
        for (int x = box.left; x <= box.right; ++x) {
          const Eigen::Vector2d at(x + 0.5, y + 0.5);
          const double here = thing.depthAt(at);
          const std::size_t pixel =
              static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
              static_cast<std::size_t>(x);
          if (!(here < depth[pixel]))
            continue;
          depth[pixel] = here;
          image.pixels[pixel] = thing.colorAt(at);
        }
    }
  }
  return image;
}

} // namespace linelet::screen
