// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/features/noise_rate.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace linelet {

double
noiseRate(const std::vector<MultiScaleShape>& shapes)
{
  double sum = 0;
  std::size_t count = 0;
  for (const MultiScaleShape& shape : shapes)
    if (!std::isnan(shape.min_sphericity)) {
      sum += static_cast<double>(shape.min_sphericity);
      ++count;
    }
  return count > 0 ? 3.15 * sum / static_cast<double>(count)
                   : std::numeric_limits<double>::quiet_NaN();
}

double
noiseWidth(const std::vector<MultiScaleShape>& shapes)
{
  constexpr double width_by_radius = 0.36;
  std::vector<double> widths;
  for (const MultiScaleShape& shape : shapes)
    if (shape.scale >= 0)
      widths.push_back(static_cast<double>(shape.optimal_radius) *
                       std::sqrt(static_cast<double>(shape.sphericity)));
  if (widths.empty())
    return std::numeric_limits<double>::quiet_NaN();
  const auto middle =
      widths.begin() + static_cast<std::ptrdiff_t>((widths.size() - 1) / 2);
  std::nth_element(widths.begin(), middle, widths.end());
  return width_by_radius * *middle;
}

} // namespace linelet
