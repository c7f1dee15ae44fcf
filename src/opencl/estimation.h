// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <vector>

#include <linelet/features/tensor_estimation.h>
#include <linelet/opencl/stage_times.h>
#include <linelet/support/points.h>
#include <linelet/support/progress_monitor.h>

#include "slabs.h"

namespace linelet::opencl {

/** \brief The result of an estimation. */
struct Outcome {
  std::vector<PointDistributionTensor> records;
  StageTimes times;
  std::size_t slabs = 0;
  std::size_t on_host = 0; ///< queries that the host had to complete
};

/** \brief \ref TensorEngine::estimate on an open device, with settings that it
 * supports.
 * \throws cl::Error, Error, Canceled */
Outcome
estimateOn(Context& context,
           std::size_t memory_limit,
           const Points& surface,
           const Points& queries,
           const TensorSettings& settings,
           const NeighborhoodSizes& sizes,
           ProgressMonitor* monitor);

} // namespace linelet::opencl
