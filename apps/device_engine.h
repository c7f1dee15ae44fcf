// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <string>
#include <vector>

#include <linelet/features/engine_choice.h>

#include "frame.h"

namespace linelet::apps {

/** \brief `--engine opencl`: the tensors of the queries from an OpenCL device, which is
 * named in the frame's summary together with the time of every stage.
 * \param[in] device number or part of a name, empty: the first GPU, else the first
 * \throws std::runtime_error where linelet was built without OpenCL, or has no device
 */
std::vector<PointDistributionTensor>
estimateOnDevice(const std::string& device,
                 const Points& points,
                 const Points& queries,
                 const TensorSettings& settings,
                 const NeighborhoodSizes& sizes,
                 Frame& frame);

/** \brief What `--engine auto` takes the costs of a GPU to be; nothing where there is
 * none, or \a work is too little for any. No GPU was at hand to measure these costs:
 * they are set high rather than low. */
std::optional<DeviceCost>
gpuCost(const std::string& device, const EngineWork& work);

} // namespace linelet::apps
