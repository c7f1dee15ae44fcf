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
isCheapest(const DeviceCost& device, const EngineWork& work, Centroid centroid)
{
  constexpr double threads = 8;
  return centroid != Centroid::WeightedMedian &&
         estimatedSeconds(device, work) <
             linelet::estimatedSeconds(Engine::Grid, work) / threads;
}

} // namespace linelet::opencl
