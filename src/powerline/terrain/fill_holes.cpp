// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/terrain/fill_holes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include <linelet/powerline/ground.h>

namespace linelet::powerline {

void
fillHoles(std::vector<float>& raster,
          int columns,
          int rows,
          Fill fill,
          std::int64_t first_column,
          std::int64_t first_row)
{
  if (std::none_of(
          raster.begin(), raster.end(), [](float v) { return std::isnan(v); }) ||
      std::all_of(raster.begin(), raster.end(), [](float v) { return std::isnan(v); }))
    return;
  // Pairs begin at even positions, wherever the raster begins.
  const int odd_column = columns > 2 ? static_cast<int>(first_column & 1) : 0,
            odd_row = rows > 2 ? static_cast<int>(first_row & 1) : 0;
  const int half_columns = (columns + odd_column + 1) / 2,
            half_rows = (rows + odd_row + 1) / 2;
  const auto width = static_cast<std::size_t>(columns);
  const auto half_width = static_cast<std::size_t>(half_columns);
  std::vector<float> coarse(half_width * static_cast<std::size_t>(half_rows), 0.0F);
  std::vector<int> count(coarse.size(), 0);
  for (std::size_t i = 0; i < raster.size(); ++i)
    if (!std::isnan(raster[i])) {
      const std::size_t c =
          (i / width + static_cast<std::size_t>(odd_row)) / 2 * half_width +
          (i % width + static_cast<std::size_t>(odd_column)) / 2;
      if (fill == Fill::Smooth)
        coarse[c] += raster[i];
      else if (count[c] == 0 || raster[i] < coarse[c])
        coarse[c] = raster[i];
      ++count[c];
    }
  for (std::size_t i = 0; i < coarse.size(); ++i)
    if (count[i] == 0)
      coarse[i] = std::numeric_limits<float>::quiet_NaN();
    else if (fill == Fill::Smooth)
      coarse[i] /= static_cast<float>(count[i]);
  fillHoles(coarse,
            half_columns,
            half_rows,
            fill,
            (first_column - odd_column) / 2,
            (first_row - odd_row) / 2);
  Ground surface;
  surface.cell = 2;
  surface.x = 0.5 - odd_column;
  surface.y = 0.5 - odd_row;
  surface.columns = half_columns;
  surface.rows = half_rows;
  surface.heights = std::move(coarse);
  for (std::size_t i = 0; i < raster.size(); ++i)
    if (std::isnan(raster[i]))
      raster[i] = static_cast<float>(surface.heightAt(static_cast<double>(i % width),
                                                      static_cast<double>(i / width)));
}

} // namespace linelet::powerline
