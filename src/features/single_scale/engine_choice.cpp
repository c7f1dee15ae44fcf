// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/features/engine_choice.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace linelet {

namespace {

constexpr std::size_t probes = 8;         // queries of which neighbors are counted
constexpr std::size_t most_tested = 8192; // points that are tested for it

/** \brief Neighbors by radius of a few queries, on average. */
double
countedNeighbors(const Points& surface,
                 const Points& queries,
                 const TensorSettings& settings,
                 const NeighborhoodSizes& sizes)
{
  const std::size_t stride = (surface.size() + most_tested - 1) / most_tested;
  std::size_t found = 0, probed = 0;
  for (std::size_t k = 0; k < std::min(probes, queries.size()); ++k) {
    const std::size_t q = k * queries.size() / std::min(probes, queries.size());
    const double radius = settings.radius > 0 ? settings.radius : sizes.radii[q];
    ++probed;
    for (std::size_t i = 0; i < surface.size(); i += stride)
      found += (surface[i] - queries[q]).squaredNorm() <= radius * radius;
  }
  return probed == 0
             ? 0
             : static_cast<double>(found * stride) / static_cast<double>(probed);
}

} // namespace

EngineWork
engineWork(const Points& surface,
           const Points& queries,
           const TensorSettings& settings,
           const NeighborhoodSizes& sizes)
{
  EngineWork work;
  work.points = surface.size();
  work.queries = queries.size();
  work.nearest = settings.k > 0 || !sizes.counts.empty();
  if (settings.k > 0)
    work.neighbors = settings.k;
  else if (!sizes.counts.empty()) {
    for (const unsigned count : sizes.counts)
      work.neighbors += count / static_cast<double>(sizes.counts.size());
  }
  else if (settings.radius > 0 || !sizes.radii.empty())
    work.neighbors = countedNeighbors(surface, queries, settings, sizes);
  return work;
}

double
estimatedSeconds(Engine engine, const EngineWork& work, const DeviceCost* device)
{
  constexpr double never = std::numeric_limits<double>::infinity();
  const auto points = static_cast<double>(work.points);
  const auto queries = static_cast<double>(work.queries);
  const double tree = 8e-9 * points * std::log2(points + 1) +
                      queries * (3e-7 + 4.5e-8 * work.neighbors);
  const double grid = 3e-5 + 1e-7 * points;
  switch (engine) {
  case Engine::Tree:
    return tree;
  case Engine::Grid:
    return work.nearest ? tree + grid : grid + queries * (3e-7 + 2e-9 * work.neighbors);
  case Engine::OpenCL:
    return work.nearest || device == nullptr
               ? never
               : device->start + device->point * (points + queries) +
                     device->pair * queries * work.neighbors;
  case Engine::Auto:
    break;
  }
  return estimatedSeconds(cheapestEngine(work, device), work, device);
}

Engine
cheapestEngine(const EngineWork& work, const DeviceCost* device)
{
  const double grid = estimatedSeconds(Engine::Grid, work);
  constexpr double threads = 8;
  if (estimatedSeconds(Engine::OpenCL, work, device) < grid / threads)
    return Engine::OpenCL;
  return estimatedSeconds(Engine::Tree, work) < grid ? Engine::Tree : Engine::Grid;
}

Engine
chosenEngine(const Points& surface,
             const Points& queries,
             const TensorSettings& settings,
             const NeighborhoodSizes& sizes,
             const DeviceCost* device)
{
  if (settings.engine != Engine::Auto)
    return settings.engine;
  // The weighted median of the OpenCL engine is missing.
  const bool possible = settings.centroid != Centroid::WeightedMedian;
  return cheapestEngine(engineWork(surface, queries, settings, sizes),
                        possible ? device : nullptr);
}

} // namespace linelet
