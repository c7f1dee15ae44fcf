// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "device_engine.h"

#include <algorithm>
#include <stdexcept>

#ifdef LINELET_HAS_OPENCL
#include <linelet/opencl/device_cost.h>
#include <linelet/opencl/tensor_engine.h>
#endif

namespace linelet::apps {

std::vector<PointDistributionTensor>
estimateOnDevice([[maybe_unused]] const std::string& device,
                 [[maybe_unused]] const Points& points,
                 [[maybe_unused]] const Points& queries,
                 [[maybe_unused]] const TensorSettings& settings,
                 [[maybe_unused]] const NeighborhoodSizes& sizes,
                 [[maybe_unused]] Frame& frame)
{
#ifdef LINELET_HAS_OPENCL
  opencl::TensorEngine engine(device);
  auto records = engine.estimate(points, queries, settings, sizes, &frame.monitor);
  const opencl::StageTimes& times = engine.stageTimes();
  frame.summary["device"] = engine.device().name;
  frame.summary["device_slabs"] = engine.slabs();
  frame.summary["device_queries_on_host"] = engine.queriesOnHost();
  frame.summary["device_seconds"] = {{"upload", times.upload},
                                     {"grid", times.grid},
                                     {"nearest", times.nearest},
                                     {"tensor", times.tensor},
                                     {"analysis", times.analysis},
                                     {"download", times.download}};
  return records;
#else
  throw std::runtime_error("this linelet was built without OpenCL; build it where "
                           "OpenCL's headers and loader are installed, or use --engine "
                           "grid");
#endif
}

bool
gpuIsCheapest([[maybe_unused]] const std::string& device,
              [[maybe_unused]] const EngineWork& work,
              [[maybe_unused]] const TensorSettings& settings)
{
#ifdef LINELET_HAS_OPENCL
  opencl::DeviceCost cost;
  cost.start = 0.5;
  cost.point = 1e-7;
  // Listing devices loads all drivers, which takes longer than small work.
  if (!isCheapest(cost, work, settings))
    return false;
  const std::vector<opencl::Device> all = opencl::devices();
  for (std::size_t i = 0; i < all.size(); ++i) {
    const bool wished = device.empty() || device == std::to_string(i) ||
                        all[i].name.find(device) != std::string::npos;
    if (!wished || all[i].type != "gpu")
      continue;
    cost.pair = 1e-9 / std::max(1u, all[i].compute_units);
    return isCheapest(cost, work, settings);
  }
#endif
  return false;
}

} // namespace linelet::apps
