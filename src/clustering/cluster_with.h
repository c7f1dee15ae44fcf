// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>
#include <memory>
#include <vector>

#include <linelet/clustering/cluster_settings.h>
#include <linelet/clustering/clusters.h>
#include <linelet/support/progress_monitor.h>
#include <linelet/support/visibility.h>

#include "point_passes.h"

namespace linelet {
namespace LINELET_PUBLIC clustering {

/** \brief Creates an engine for points, which must outlive it, and the integers of a
 * field. */
using MakePasses = std::function<std::unique_ptr<PointPasses>(
    const Points& points, std::vector<std::int32_t> field, int threads)>;

/** \brief \ref clusterPoints with an engine, which does the work per point; the work
 * per cell is done here. */
Clusters
clusterWith(const MakePasses& make,
            const Points& points,
            const ClusterSettings& settings,
            const std::vector<double>& field,
            ProgressMonitor* monitor);

} // namespace clustering
} // namespace linelet
