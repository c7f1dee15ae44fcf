// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/features/grid_tensor_engine.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <map>
#include <memory>

#include <linelet/search/grid_search.h>
#include <linelet/support/threads.h>

#include "block_sweep.h"
#include "features/simd_grid/order/huge_pages.h"
#include "features/simd_grid/order/reach.h"

namespace linelet {

namespace grid {

namespace {

// Blocks hold that many points, or are as wide as float allows.
constexpr double least_crowding = 16;
constexpr double widest_block = 4;

/** \brief No more threads than have something to do: for few queries, waking a thread
 * costs more than it does. */
int
usefulThreads(unsigned requested, std::size_t queries)
{
  constexpr std::size_t queries_a_thread = 1024;
  const std::size_t useful = queries / queries_a_thread + 1;
  return static_cast<int>(
      std::min(useful, static_cast<std::size_t>(threadCount(requested))));
}

/** \brief Estimates around some queries, whose radii are about alike. */
class Estimate {
public:
  Estimate(const Points& surface,
           const Points& queries,
           const TensorSettings& settings,
           const NeighborhoodSizes& sizes,
           ProgressMonitor* monitor,
           std::vector<PointDistributionTensor>& records)
      : surface_(surface),
        queries_(queries),
        settings_(settings),
        weight_(settings.weighting),
        sizes_(sizes),
        monitor_(monitor),
        records_(records),
        bounds_(surface),
        reach_(reachOf(surface, queries)),
        threads_(usefulThreads(settings.threads, queries.size()))
  {
  }

  double
  reach() const
  {
    return reach_;
  }

  /** \param[in] radius of the queries, or the longest of them
   * \param[in] chosen indices of the queries, or null for all */
  void
  run(double radius, const Indices* chosen)
  {
    if (bounds_.empty())
      return;
    radius = std::min(radius, reach_);
    if (!BlockFrame::fits(bounds_.low, bounds_.high, radius)) {
      plain(radius, chosen);
      return;
    }
    // Neighbors lie in the next block at most, for all rounding of its place.
    double edge = radius * (1 + 1e-6);
    BlockFrame frame(bounds_.low, bounds_.high, edge);
    auto surface = std::make_unique<BlockOrder>(surface_, nullptr, frame, threads_);
    while (surface->crowding() < least_crowding && edge * 2 <= widest_block * radius) {
      edge *= 2;
      frame = BlockFrame(bounds_.low, bounds_.high, edge);
      surface.reset();
      surface = std::make_unique<BlockOrder>(surface_, nullptr, frame, threads_);
    }
    if (&surface_ == &queries_ && chosen == nullptr)
      sweep(frame, *surface, *surface, radius);
    else
      sweep(frame, *surface, BlockOrder(queries_, chosen, frame, threads_), radius);
  }

private:
  void
  sweep(const BlockFrame& frame,
        const BlockOrder& surface,
        const BlockOrder& queries,
        double radius)
  {
    std::atomic<bool> stop{false};
    const SweepJob job{frame,
                       surface,
                       queries,
                       settings_,
                       weight_,
                       radius,
                       reach_,
                       sizes_.radii.empty() ? nullptr : &sizes_.radii,
                       records_.data(),
                       monitor_,
                       stop};
    const auto blocks = static_cast<std::ptrdiff_t>(queries.blocks());
#pragma omp parallel num_threads(threads_)
    {
      BlockSweep sweep_block(job);
#pragma omp for schedule(dynamic, 4)
      for (std::ptrdiff_t b = 0; b < blocks; ++b) {
        if (stop)
          continue;
        const auto block = static_cast<std::size_t>(b);
        sweep_block(block);
        if (monitor_ != nullptr) {
          monitor_->advance(queries.begin(block + 1) - queries.begin(block));
          if (monitor_->canceled())
            stop = true;
        }
      }
    }
    if (stop)
      throw Canceled();
  }

  /** \brief For radii so small beside the extent that blocks cannot be numbered. */
  void
  plain(double radius, const Indices* chosen)
  {
    const GridSearch search(surface_, radius);
    Points queries;
    NeighborhoodSizes sizes;
    TensorSettings settings = settings_;
    settings.radius = 0;
    const std::size_t count = chosen != nullptr ? chosen->size() : queries_.size();
    const auto index = [&](std::size_t i) {
      return chosen != nullptr ? (*chosen)[i] : i;
    };
    for (std::size_t i = 0; i < count; ++i) {
      queries.push_back(queries_[index(i)]);
      sizes.radii.push_back(sizes_.radii.empty() ? radius : sizes_.radii[index(i)]);
    }
    const auto records =
        estimateTensors(search, surface_, queries, settings, sizes, monitor_);
    for (std::size_t i = 0; i < count; ++i)
      records_[index(i)] = records[i];
  }

  const Points& surface_;
  const Points& queries_;
  const TensorSettings& settings_;
  SweepWeight weight_;
  const NeighborhoodSizes& sizes_;
  ProgressMonitor* monitor_;
  std::vector<PointDistributionTensor>& records_;
  Bounds bounds_;
  double reach_;
  int threads_;
};

} // namespace

} // namespace grid

std::vector<PointDistributionTensor>
estimateTensorsOnGrid(const Points& surface,
                      const Points& queries,
                      const TensorSettings& settings,
                      const NeighborhoodSizes& sizes,
                      ProgressMonitor* monitor)
{
  validate(settings, sizes, queries.size());
  std::vector<PointDistributionTensor> records;
  grid::reserveHuge(records, queries.size());
  records.resize(queries.size(), unknownTensor(0));
  if (monitor != nullptr)
    monitor->begin("tensor", queries.size());
  grid::Estimate estimate(surface, queries, settings, sizes, monitor, records);
  if (sizes.radii.empty()) {
    if (!queries.empty())
      estimate.run(settings.radius, nullptr);
    return records;
  }
  // Radii within a factor of two go together, as do those that reach everything.
  std::map<int, Indices> classes;
  for (std::size_t i = 0; i < queries.size(); ++i)
    if (sizes.radii[i] > 0 && std::isfinite(sizes.radii[i]))
      classes[std::ilogb(std::min(sizes.radii[i], estimate.reach()))].push_back(
          static_cast<Index>(i));
  for (const auto& [exponent, chosen] : classes) {
    double longest = 0;
    for (const Index i : chosen)
      longest = std::max(longest, sizes.radii[i]);
    estimate.run(longest, &chosen);
  }
  return records;
}

std::string_view
gridInstructionSet()
{
  return grid::sweepKernels().target;
}

} // namespace linelet
