// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <linelet/clustering/cluster_settings.h>
#include <linelet/support/points.h>

#include "point_passes.h"

namespace linelet::clustering {

/** \brief The edge of cubic cells of which about \a settings.count hold points: within
 * half a percent, or as close as the cloud allows. */
double
leafForCount(PointPasses& passes,
             const Points& points,
             const ClusterSettings& settings,
             int threads);

} // namespace linelet::clustering
