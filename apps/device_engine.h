// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include <linelet/features/tensor_estimation.h>

#include "frame.h"

namespace linelet::apps {

/** \brief `--engine opencl`: the tensors of all points from an OpenCL device, which is
 * named in the frame's summary together with the time of every stage.
 * \param[in] device number or part of a name, empty: the first GPU, else the first
 * \throws std::runtime_error where linelet was built without OpenCL, or has no device
 */
std::vector<PointDistributionTensor>
estimateOnDevice(const std::string& device,
                 const Points& points,
                 const TensorSettings& settings,
                 const NeighbourhoodSizes& sizes,
                 Frame& frame);

} // namespace linelet::apps
