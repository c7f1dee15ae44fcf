// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "neighbor_finder.h"

#include <stdexcept>

#include <linelet/features/tensor_estimation.h>

namespace linelet::apps {

void
settle(NeighborFinder& finder)
{
  if (finder.search == SearchOption::Auto)
    return;
  if (finder.engine != EngineOption::Auto)
    throw std::runtime_error("--search " + std::string(nameOf(finder.search)) +
                             " and --engine " + std::string(nameOf(finder.engine)) +
                             " both choose how neighbors are found; give only one");
  finder.engine =
      finder.search == SearchOption::Grid ? EngineOption::Grid : EngineOption::Tree;
}

std::vector<PointDistributionTensor>
tensorsWith(const NeighborFinder& finder,
            const Points& points,
            const Points& queries,
            TensorSettings settings,
            const NeighborhoodSizes& sizes,
            Frame& frame)
{
  if (isOfPcl(finder.search))
    return estimateWithPcl(
        finder.search, points, queries, settings, sizes, &frame.monitor);
  settings.engine = finder.onProcessor();
  if (finder.engine != EngineOption::OpenCL)
    return estimateTensors(points, queries, settings, sizes, &frame.monitor);
  DeviceEngine device(finder.device);
  auto records = device.estimate(points, queries, settings, sizes, &frame.monitor);
  device.summarize(frame.summary);
  return records;
}

} // namespace linelet::apps
