// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/clustering/cluster_points.h>

#include "cluster_with.h"
#include "host_passes.h"

namespace linelet {

Clusters
clusterPoints(const Points& points,
              const ClusterSettings& settings,
              const std::vector<double>& field,
              ProgressMonitor* monitor)
{
  return clustering::clusterWith(
      clustering::hostPasses, points, settings, field, monitor);
}

} // namespace linelet
