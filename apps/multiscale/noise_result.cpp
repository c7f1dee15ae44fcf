// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "noise_result.h"

#include <algorithm>
#include <cstdio>

#include <linelet/features/noise_rate.h>

namespace linelet::apps {

MultiScaleSettings
aboutPoints(MultiScaleSettings settings)
{
  settings.centroid = Centroid::QueryPoint;
  return settings;
}

NoiseResult
resultOf(const std::vector<MultiScaleShape>& shapes,
         const std::vector<MultiScaleShape>& about_points,
         std::size_t left_out)
{
  const auto without_scale =
      std::count_if(shapes.begin(), shapes.end(), [](const MultiScaleShape& shape) {
        return shape.scale < 0;
      });
  return {noiseRate(about_points),
          noiseWidth(about_points),
          shapes.size(),
          left_out,
          static_cast<std::size_t>(without_scale) - left_out};
}

void
print(const NoiseResult& result,
      const MultiScaleShapes& plan,
      const MultiScaleSettings& settings,
      const std::string& file)
{
  std::printf("%s: %zu points, scale unit D %.6g, %zu radii from %.6g to %.6g\n"
              "noise rate %.4f, noise width %.4g\n",
              file.c_str(),
              result.points,
              plan.scale_unit,
              plan.radii.size(),
              plan.radii.front(),
              plan.radii.back(),
              result.noise_rate,
              result.noise_width);
  printUnknown(result.unknown, settings);
}

void
printUnknown(std::size_t unknown, const MultiScaleSettings& settings)
{
  if (unknown > 0)
    std::printf("%zu points have no optimal scale: fewer than %u points within the "
                "largest radius\n",
                unknown,
                settings.graph.min_neighbors);
}

} // namespace linelet::apps
