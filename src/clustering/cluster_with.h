// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>
#include <memory>
#include <vector>

#include <linelet/clustering/cluster_points.h>
#include <linelet/support/visibility.h>

#include "point_passes.h"

namespace linelet {
namespace LINELET_PUBLIC clustering {

/** \brief Makes an engine for points, which outlive it, and a field's integers. */
using MakePasses = std::function<std::unique_ptr<PointPasses>(
    const Points& points, std::vector<std::int32_t> field, int threads)>;

/** \brief \ref clusterPoints with an engine: it does what is done point by point,
 * everything that is done cell by cell is done here. */
Clusters
clusterWith(const MakePasses& make,
            const Points& points,
            const ClusterSettings& settings,
            const std::vector<double>& field,
            ProgressMonitor* monitor);

} // namespace clustering
} // namespace linelet
