// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/powerline/ground.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace linelet::powerline {

double
Ground::heightAt(double at_x, double at_y) const
{
  if (heights.empty() || !std::isfinite(at_x) || !std::isfinite(at_y))
    return std::numeric_limits<double>::quiet_NaN();
  const double u = std::clamp((at_x - x) / cell, 0.0, static_cast<double>(columns - 1));
  const double v = std::clamp((at_y - y) / cell, 0.0, static_cast<double>(rows - 1));
  const auto column = static_cast<std::size_t>(u), row = static_cast<std::size_t>(v);
  const std::size_t right = std::min(column + 1, static_cast<std::size_t>(columns - 1));
  const std::size_t above = std::min(row + 1, static_cast<std::size_t>(rows - 1));
  const double fu = u - static_cast<double>(column), fv = v - static_cast<double>(row);
  const auto height = [&](std::size_t c, std::size_t r) {
    return static_cast<double>(heights[r * static_cast<std::size_t>(columns) + c]);
  };
  return (1 - fv) * ((1 - fu) * height(column, row) + fu * height(right, row)) +
         fv * ((1 - fu) * height(column, above) + fu * height(right, above));
}

} // namespace linelet::powerline
