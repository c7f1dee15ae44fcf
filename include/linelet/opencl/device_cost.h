// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <linelet/features/engine_choice.h>
#include <linelet/support/visibility.h>

namespace linelet {
namespace LINELET_PUBLIC opencl {

/** \brief What work on an OpenCL device costs, in seconds. */
struct DeviceCost {
  double start = 0; ///< opening the device and building the kernels
  double point = 0; ///< transfer, cells and sorting, per point
  double pair = 0;  ///< per pair of a query and a neighbor
};

/** \brief Seconds that a device needs for \a work; infinite for k nearest points. */
double
estimatedSeconds(const DeviceCost& device, const EngineWork& work);

/** \brief Whether \a device is the cheapest engine. It has to beat the grid on eight
 * threads, whatever this machine has, so that the choice depends only on the work.
 * Never true for settings that \ref TensorEngine::estimate refuses. */
bool
isCheapest(const DeviceCost& device,
           const EngineWork& work,
           const TensorSettings& settings);

/** \brief Why the engine cannot compute with \a settings; null if it can. The weighted
 * median and unbounded weightings need double precision. */
const char*
unsupported(const TensorSettings& settings);

} // namespace opencl
} // namespace linelet
