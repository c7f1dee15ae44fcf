// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <linelet/support/visibility.h>

namespace LINELET_PUBLIC linelet {

/** \brief A picture with transparency, row by row: red, green and blue, premultiplied
 * by alpha, and alpha. */
struct GlyphImage {
  int width = 0, height = 0;
  std::vector<std::array<float, 4>> pixels;

  std::array<float, 4>&
  at(int x, int y)
  {
    return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)];
  }
  const std::array<float, 4>&
  at(int x, int y) const
  {
    return const_cast<GlyphImage*>(this)->at(x, y);
  }
};

} // namespace linelet
