// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "device_engine.h"

#include <stdexcept>

#ifdef LINELET_HAS_OPENCL
#include <linelet/opencl/tensor_engine.h>
#endif

namespace linelet::apps {

std::vector<PointDistributionTensor>
estimateOnDevice([[maybe_unused]] const std::string& device,
                 [[maybe_unused]] const Points& points,
                 [[maybe_unused]] const TensorSettings& settings,
                 [[maybe_unused]] const NeighbourhoodSizes& sizes,
                 [[maybe_unused]] Frame& frame)
{
#ifdef LINELET_HAS_OPENCL
  opencl::TensorEngine engine(device);
  auto records = engine.estimate(points, points, settings, sizes, &frame.monitor);
  const opencl::StageTimes& times = engine.stageTimes();
  frame.summary["device"] = engine.device().name;
  frame.summary["device_slabs"] = engine.slabs();
  frame.summary["device_seconds"] = {{"upload", times.upload},
                                     {"grid", times.grid},
                                     {"tensor", times.tensor},
                                     {"download", times.download},
                                     {"analysis", times.analysis}};
  return records;
#else
  throw std::runtime_error("this linelet was built without OpenCL; build it where "
                           "OpenCL's headers and loader are installed, or use --engine "
                           "grid");
#endif
}

} // namespace linelet::apps
