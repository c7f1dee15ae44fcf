// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <linelet/features/multi_scale.h>

namespace linelet::apps {

/** \brief What the multi-scale feature of a cloud costs. */
struct ScaleCost {
  double neighbors = 0; ///< of a point within the largest radius, on average
  double seconds = 0;   ///< wall time for all points
};

/** \brief The cost for \a points, measured on a few of them. */
ScaleCost
estimateCost(const Points& points, const MultiScaleSettings& settings);

} // namespace linelet::apps
