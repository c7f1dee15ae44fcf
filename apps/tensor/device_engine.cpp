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

#ifdef LINELET_HAS_OPENCL

struct DeviceEngine::State {
  explicit State(const std::string& device) : engine(device) {}

  opencl::TensorEngine engine;
};

DeviceEngine::DeviceEngine(const std::string& device)
    : state_(std::make_unique<State>(device))
{
}

std::vector<PointDistributionTensor>
DeviceEngine::estimate(const Points& points,
                       const Points& queries,
                       const TensorSettings& settings,
                       const NeighborhoodSizes& sizes,
                       ProgressMonitor* monitor)
{
  return state_->engine.estimate(points, queries, settings, sizes, monitor);
}

void
DeviceEngine::summarize(nlohmann::ordered_json& summary) const
{
  const opencl::StageTimes& times = state_->engine.stageTimes();
  summary["device"] = state_->engine.device().name;
  summary["device_slabs"] = state_->engine.slabs();
  summary["device_queries_on_host"] = state_->engine.queriesOnHost();
  summary["device_seconds"] = {{"upload", times.upload},
                               {"grid", times.grid},
                               {"nearest", times.nearest},
                               {"tensor", times.tensor},
                               {"analysis", times.analysis},
                               {"download", times.download}};
}

std::vector<NamedDevice>
devicesNamed(const std::string& part)
{
  std::vector<NamedDevice> found;
  std::size_t number = 0;
  for (const opencl::Device& device : opencl::devices()) {
    const std::string place = std::to_string(number++);
    if (device.name.find(part) != std::string::npos)
      found.push_back({place, place + " " + device.name});
  }
  return found;
}

#else

struct DeviceEngine::State {};

DeviceEngine::DeviceEngine(const std::string&)
{
  throw std::runtime_error("this linelet was built without OpenCL; build it where "
                           "OpenCL's headers and loader are installed, or use --engine "
                           "grid");
}

std::vector<PointDistributionTensor>
DeviceEngine::estimate(const Points&,
                       const Points&,
                       const TensorSettings&,
                       const NeighborhoodSizes&,
                       ProgressMonitor*)
{
  return {};
}

void
DeviceEngine::summarize(nlohmann::ordered_json&) const
{
}

std::vector<NamedDevice>
devicesNamed(const std::string&)
{
  return {};
}

#endif

DeviceEngine::~DeviceEngine() = default;

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
