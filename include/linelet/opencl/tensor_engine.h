// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include <linelet/features/tensor_estimation.h>
#include <linelet/opencl/device.h>
#include <linelet/support/visibility.h>

namespace linelet {
namespace LINELET_PUBLIC opencl {

/** \brief What a part of the work took, in seconds of wall time. */
struct StageTimes {
  double upload = 0;   ///< cells and places on the host, and their way to the device
  double grid = 0;     ///< keys of cells, sorting and the table of cells
  double nearest = 0;  ///< the search for k nearest points
  double tensor = 0;   ///< the tensor kernel
  double analysis = 0; ///< eigen-analysis and records, on the device
  double download = 0; ///< the way back
};

/** \brief The neighborhood tensor on an OpenCL 1.2 device (Grasso et al. 2015).
 *
 * Keys of cells, a bitonic sort, neighbors, centroids, tensors and their
 * eigen-analysis are computed on the device, in float relative to each query point.
 * Shape factors agree with \ref estimateTensors within 1e-4, neighbors exactly: pairs
 * that float cannot tell are decided in double, where the device has none by completing
 * these queries on the host. The k nearest points are those of the ball that counting
 * narrows down to; queries around which several are equally far, or which lie far from
 * all points, are completed on the host as well.
 *
 * A cloud that does not fit into the device's memory, or whose cells are too many for a
 * key of 64 bits, is cut into slabs with a margin as wide as the radius. A device that
 * is a processor runs on all of its cores. Not for use by several threads at once. */
class TensorEngine {
public:
  /** \brief Opens a device: the first GPU, else the first of any kind; or the one of
   * the number or with the part of a name given.
   * \throws Error listing the devices where there is none such */
  explicit TensorEngine(const std::string& device = {});
  ~TensorEngine();
  TensorEngine(TensorEngine&&) noexcept;
  TensorEngine&
  operator=(TensorEngine&&) noexcept;

  const Device&
  device() const;

  /** \brief Uses at most \a bytes of the device's memory at a time; 0, as at the start,
   * stands for four fifths of what it has. */
  void
  setMemoryLimit(std::size_t bytes);

  /** \brief As \ref linelet::estimateTensors; settings.engine has no say,
   * settings.threads is for the host's part.
   * \throws std::invalid_argument for what is \ref unsupported, and for k nearest
   * points on a device without double precision
   * \throws Error
   * \throws Canceled between slabs */
  std::vector<PointDistributionTensor>
  estimate(const Points& surface,
           const Points& queries,
           const TensorSettings& settings,
           const NeighborhoodSizes& sizes = {},
           ProgressMonitor* monitor = nullptr);

  /** \brief Of the last \ref estimate, summed over its slabs. */
  const StageTimes&
  stageTimes() const;

  /** \brief How many queries of the last \ref estimate the host completed. */
  std::size_t
  queriesOnHost() const;

  /** \brief How many slabs the last \ref estimate was cut into: 1 if all fits; radii of
   * each magnitude, and each round of the search for nearest points, have their own. */
  std::size_t
  slabs() const;

private:
  struct State;
  std::unique_ptr<State> state_;
};

} // namespace opencl
} // namespace linelet
