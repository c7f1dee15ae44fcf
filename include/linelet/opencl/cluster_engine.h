// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <string>
#include <vector>

#include <linelet/clustering/cluster_points.h>
#include <linelet/opencl/device.h>
#include <linelet/support/visibility.h>

namespace linelet {
namespace LINELET_PUBLIC opencl {

/** \brief \ref linelet::clusterPoints on an OpenCL 1.2 device with double precision,
 * bit for bit: the device computes cells, sums and moves of points, the host the planes
 * and means of cells. Not for use by several threads at once. */
class ClusterEngine {
public:
  /** \brief Opens a device, as \ref TensorEngine does. \throws Error also if it has no
   * double precision */
  explicit ClusterEngine(const std::string& device = {});
  ~ClusterEngine();
  ClusterEngine(ClusterEngine&&) noexcept;
  ClusterEngine&
  operator=(ClusterEngine&&) noexcept;

  const Device&
  device() const;

  /** \brief See \ref linelet::clusterPoints. \throws Error */
  Clusters
  cluster(const Points& points,
          const ClusterSettings& settings,
          const std::vector<double>& field = {},
          ProgressMonitor* monitor = nullptr);

private:
  struct State;
  std::unique_ptr<State> state_;
};

} // namespace opencl
} // namespace linelet
