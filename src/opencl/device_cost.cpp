// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/opencl/device_cost.h>

#include <limits>

namespace linelet::opencl {

double
estimatedSeconds(const DeviceCost& device, const EngineWork& work)
{
  if (work.nearest)
    return std::numeric_limits<double>::infinity();
  const auto points = static_cast<double>(work.points);
  const auto queries = static_cast<double>(work.queries);
  return device.start + device.point * (points + queries) +
         device.pair * queries * work.neighbors;
}

bool
isCheapest(const DeviceCost& device,
           const EngineWork& work,
           const TensorSettings& settings)
{
  constexpr double threads = 8;
  return unsupported(settings) == nullptr &&
         estimatedSeconds(device, work) <
             linelet::estimatedSeconds(Engine::Grid, work) / threads;
}

const char*
unsupported(const TensorSettings& settings)
{
  if (settings.centroid == Centroid::WeightedMedian)
    return "the OpenCL engine has no weighted median: in float, chance would decide "
           "between its minima; choose the engine grid or tree";
  if (isUnbounded(settings.weighting.kernel()) ||
      (settings.centroid == Centroid::WeightedMean &&
       isUnbounded(settings.centroid_weighting.kernel())))
    return "the OpenCL engine has no unbounded weighting: float is too coarse near the "
           "centroid; choose the engine grid or tree";
  return nullptr;
}

} // namespace linelet::opencl
