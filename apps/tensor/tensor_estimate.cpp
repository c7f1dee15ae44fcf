// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tensor_estimate.h"

#include <stdexcept>
#include <string>

#include <linelet/features/tensor_estimation.h>

#include "scale_cost.h"

namespace linelet::apps {

void
announceTensors(const Points& points,
                const TensorSettings& settings,
                const NeighborFinder& finder,
                const NeighborhoodSizes& sizes,
                Frame& frame)
{
  constexpr double most_pairs = 1e9;
  const EngineWork work = engineWork(points, points, settings, sizes);
  if (work.neighbors * static_cast<double>(work.queries) < most_pairs)
    return;
  const bool grid = finder.engine != EngineOption::Tree && !work.nearest;
  const ScaleCost cost =
      measuredCost(points, grid ? 3200 : 160, [&](const Indices& chosen) {
        Points queries;
        NeighborhoodSizes some;
        for (const Index i : chosen) {
          queries.push_back(points[i]);
          if (!sizes.radii.empty())
            some.radii.push_back(sizes.radii[i]);
          if (!sizes.counts.empty())
            some.counts.push_back(sizes.counts[i]);
        }
        double neighbors = 0;
        for (const auto& record :
             tensorsWith(finder, points, queries, settings, some, frame))
          neighbors += record.neighbors;
        return neighbors;
      });
  announce(
      cost, points.size(), "mean of some", work.nearest ? "--knn" : "--radius", frame);
}

std::vector<PointDistributionTensor>
estimate(const Points& points,
         TensorSettings& settings,
         NeighborFinder& finder,
         const NeighborhoodSizes& sizes,
         Frame& frame)
{
  // Invalid sizes are rejected first.
  validate(settings, sizes, points.size());
  EngineOption& engine = finder.engine;
  const bool automatic = engine == EngineOption::Auto;
  if (automatic) {
    const EngineWork work = engineWork(points, points, settings, sizes);
    engine = gpuIsCheapest(finder.device, work, settings)
                 ? EngineOption::OpenCL
                 : optionOf(cheapestEngine(work));
  }
  try {
    announceTensors(points, settings, finder, sizes, frame);
    return tensorsWith(finder, points, points, settings, sizes, frame);
  }
  catch (const Canceled&) {
    throw;
  }
  catch (const std::runtime_error& error) {
    if (!automatic || engine != EngineOption::OpenCL)
      throw;
    frame.warn(std::string(error.what()) + "; using engine grid instead");
  }
  engine = EngineOption::Grid;
  return tensorsWith(finder, points, points, settings, sizes, frame);
}

} // namespace linelet::apps
