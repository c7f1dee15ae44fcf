// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <linelet/features/multi_scale_settings.h>
#include <linelet/features/multi_scale_types.h>

namespace linelet::apps {

/** \brief Results for a file: how far the points are from their curves, and how many
 * points have no scale. */
struct NoiseResult {
  double noise_rate, noise_width;
  std::size_t points, left_out, unknown;
};

/** \param[in] about_points the shapes with tensors about the points themselves */
NoiseResult
resultOf(const std::vector<MultiScaleShape>& shapes,
         const std::vector<MultiScaleShape>& about_points,
         std::size_t left_out);

/** \brief Reports the results for \a file. */
void
print(const NoiseResult& result,
      const MultiScaleShapes& plan,
      const MultiScaleSettings& settings,
      const std::string& file);

/** \brief Reports how many points have no optimal scale, if any. */
void
printUnknown(std::size_t unknown, const MultiScaleSettings& settings);

/** \brief The noise measures are defined for shapes about the query points. */
MultiScaleSettings
aboutPoints(MultiScaleSettings settings);

} // namespace linelet::apps
