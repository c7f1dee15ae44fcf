// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include <linelet/features/tensor_estimation.h>
#include <linelet/opencl/device.h>
#include <linelet/opencl/stage_times.h>
#include <linelet/support/visibility.h>

namespace linelet {
namespace LINELET_PUBLIC opencl {

/** \brief The neighborhood tensor on an OpenCL 1.2 device (Grasso et al. 2015).
 *
 * Cell keys, a bitonic sort, neighbors, centroids, tensors and their eigen-analysis are
 * computed on the device, in float relative to each query point. Shape factors agree
 * with \ref estimateTensors within 1e-4, neighbors exactly: pairs that float cannot
 * decide are decided in double; on a device without double, the host completes these
 * queries. The k nearest points are those of a ball that is narrowed down by counting;
 * queries with ties, or far from all points, are completed on the host as well.
 *
 * A cloud that does not fit into the device's memory, or has too many cells for a
 * 64-bit key, is cut into slabs with a margin as wide as the radius. A CPU device runs
 * on all of its cores. Not for use by several threads at once. */
class TensorEngine {
public:
  /** \brief Opens a device: by number or part of its name; if empty, the first GPU,
   * else the first device of any kind.
   * \throws Error listing the devices if there is no such device */
  explicit TensorEngine(const std::string& device = {});
  ~TensorEngine();
  TensorEngine(TensorEngine&&) noexcept;
  TensorEngine&
  operator=(TensorEngine&&) noexcept;

  const Device&
  device() const;

  /** \brief Uses at most \a bytes of the device's memory at a time; 0 (default): four
   * fifths of it. */
  void
  setMemoryLimit(std::size_t bytes);

  /** \brief As \ref linelet::estimateTensors; settings.engine has no effect, and
   * settings.threads is for the host's part.
   * \throws std::invalid_argument if \ref unsupported, and for k nearest points on a
   * device without double precision
   * \throws Error
   * \throws Canceled between slabs */
  std::vector<PointDistributionTensor>
  estimate(const Points& surface,
           const Points& queries,
           const TensorSettings& settings,
           const NeighborhoodSizes& sizes = {},
           ProgressMonitor* monitor = nullptr);

  /** \brief Times of the last \ref estimate, summed over its slabs. */
  const StageTimes&
  stageTimes() const;

  /** \brief How many queries of the last \ref estimate the host completed. */
  std::size_t
  queriesOnHost() const;

  /** \brief How many slabs the last \ref estimate was cut into: 1 if everything fits;
   * radii of each order of magnitude, and each round of the search for nearest points,
   * have their own. */
  std::size_t
  slabs() const;

private:
  struct State;
  std::unique_ptr<State> state_;
};

} // namespace opencl
} // namespace linelet
