// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <linelet/tensor/centroid.h>
#include <linelet/tensor/weighting.h>

namespace linelet::grid {

/** \brief How a sweep computes tensors. */
enum class SweepMethod {
  Sums,    ///< const around the query or the mean: sums of moments
  Weights, ///< a kernel around the query
  Center,  ///< a kernel around a mean of the neighbors
  Double   ///< neighbors from the lists, all else in double
};

/** \brief For settings with `weighting`, `centroid` and `centroid_weighting`. */
template <class Settings>
SweepMethod
sweepMethod(const Settings& settings)
{
  const bool centered = settings.centroid != Centroid::QueryPoint;
  // Rounding would decide at a step or a pole; the medians iterate to the last digit.
  const auto needs_double = [](const Weighting& weighting) {
    return weighting.kernel() == Kernel::Step || isUnbounded(weighting.kernel());
  };
  if (needs_double(settings.weighting) ||
      (centered && needs_double(settings.centroid_weighting)) ||
      settings.centroid == Centroid::Median ||
      settings.centroid == Centroid::WeightedMedian)
    return SweepMethod::Double;
  if (settings.weighting.kernel() == Kernel::Const &&
      settings.centroid != Centroid::WeightedMean)
    return SweepMethod::Sums;
  return centered ? SweepMethod::Center : SweepMethod::Weights;
}

} // namespace linelet::grid
