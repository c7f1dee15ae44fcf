// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/features/grid_tensor_engine.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <optional>

#include <linelet/features/tensor_search.h>
#include <linelet/search/grid_search.h>
#include <linelet/support/threads.h>

#include "block_sweep.h"
#include "features/simd_grid/order/reach.h"
#include "support/huge_pages.h"
#include "support/parallel_failure.h"

namespace linelet {

namespace grid {

namespace {

// Edge of a block in radii: of 1 to 4 the best for thin clouds and for dense ones.
// Independent of the density, so that a part of a cloud has the blocks of the whole.
constexpr double block_edge = 2;

/** \brief No more threads than have something to do: for few queries, waking a thread
 * costs more than it saves. */
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
           const CloudPiece* piece,
           ProgressMonitor* monitor,
           std::vector<PointDistributionTensor>& records)
      : surface_(surface),
        queries_(queries),
        settings_(settings),
        weight_(settings.weighting),
        sizes_(sizes),
        piece_(piece),
        monitor_(monitor),
        records_(records),
        bounds_(surface),
        whole_(surface, piece),
        reach_(reachOf(extent())),
        threads_(usefulThreads(settings.threads, queries.size()))
  {
  }

  double
  reach() const
  {
    return reach_;
  }

  /** \param[in] radius of the queries, or one that none exceeds
   * \param[in] chosen indices of the queries, or null for all */
  void
  run(double radius, const Indices* chosen)
  {
    if (bounds_.empty())
      return;
    radius = std::min(radius, reach_);
    if (!BlockFrame::fits(whole_.low, whole_.high, radius)) {
      plain(radius, chosen);
      return;
    }
    // Despite rounding, neighbors are at most one block away.
    const BlockFrame frame(bounds_.low, bounds_.high, block_edge * radius);
    const BlockOrder surface(surface_, nullptr, frame, threads_);
    if (&surface_ == &queries_ && chosen == nullptr)
      sweep(frame, surface, surface, radius);
    else
      sweep(frame, surface, BlockOrder(queries_, chosen, frame, threads_), radius);
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
    ParallelFailure failure;
#pragma omp parallel num_threads(threads_)
    {
      std::optional<BlockSweep> sweep_block;
      failure.guard([&] { sweep_block.emplace(job); });
#pragma omp for schedule(dynamic, 4)
      for (std::ptrdiff_t b = 0; b < blocks; ++b) {
        if (stop)
          continue;
        const auto block = static_cast<std::size_t>(b);
        if (!isWanted(queries, block))
          continue;
        failure.guard([&] {
          (*sweep_block)(block);
          if (monitor_ != nullptr) {
            monitor_->advance(queries.begin(block + 1) - queries.begin(block));
            if (monitor_->canceled())
              stop = true;
          }
        });
      }
    }
    failure.rethrow();
    if (stop)
      throw Canceled();
  }

  /** \brief Of all points and queries. */
  Bounds
  extent() const
  {
    Bounds bounds = whole_;
    if (&queries_ != &surface_)
      bounds.add(queries_);
    return bounds;
  }

  bool
  isWanted(const BlockOrder& queries, std::size_t block) const
  {
    if (piece_ == nullptr)
      return true;
    for (std::size_t i = queries.begin(block); i < queries.begin(block + 1); ++i)
      if (queries.index(i) >= piece_->begin && queries.index(i) < piece_->end)
        return true;
    return false;
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
  const CloudPiece* piece_; // null: all queries are wanted
  ProgressMonitor* monitor_;
  std::vector<PointDistributionTensor>& records_;
  Bounds bounds_, whole_;
  double reach_;
  int threads_;
};

std::vector<PointDistributionTensor>
recordsOf(const Points& surface,
          const Points& queries,
          const TensorSettings& settings,
          const NeighborhoodSizes& sizes,
          const CloudPiece* piece,
          ProgressMonitor* monitor)
{
  validate(settings, sizes, queries.size());
  std::vector<PointDistributionTensor> records;
  reserveHuge(records, queries.size());
  records.resize(queries.size(), unknownTensor(0));
  if (monitor != nullptr)
    monitor->begin("tensor", queries.size());
  Estimate estimate(surface, queries, settings, sizes, piece, monitor, records);
  if (sizes.radii.empty()) {
    if (!queries.empty())
      estimate.run(settings.radius, nullptr);
    return records;
  }
  // Queries whose radii lie between the same powers of two go together, in blocks that
  // no other radius changes, as do those that reach everything.
  std::map<double, Indices> classes;
  for (std::size_t i = 0; i < queries.size(); ++i)
    if (sizes.radii[i] > 0 && std::isfinite(sizes.radii[i]))
      classes[powerAbove(std::min(sizes.radii[i], estimate.reach() / 2))].push_back(
          static_cast<Index>(i));
  for (const auto& [radius, chosen] : classes)
    estimate.run(radius, &chosen);
  return records;
}

} // namespace

} // namespace grid

std::vector<PointDistributionTensor>
estimateTensorsOnGrid(const Points& surface,
                      const Points& queries,
                      const TensorSettings& settings,
                      const NeighborhoodSizes& sizes,
                      ProgressMonitor* monitor)
{
  return grid::recordsOf(surface, queries, settings, sizes, nullptr, monitor);
}

std::vector<PointDistributionTensor>
pieceTensorsOnGrid(const Points& points,
                   const CloudPiece& piece,
                   const TensorSettings& settings,
                   const NeighborhoodSizes& sizes,
                   ProgressMonitor* monitor)
{
  auto records = grid::recordsOf(points, points, settings, sizes, &piece, monitor);
  using Offset = std::vector<PointDistributionTensor>::difference_type;
  records.resize(piece.end);
  records.erase(records.begin(), records.begin() + static_cast<Offset>(piece.begin));
  return records;
}

double
gridMargin(const TensorSettings& settings, const NeighborhoodSizes& sizes)
{
  double longest = settings.radius;
  for (const double radius : sizes.radii)
    if (isRadius(radius))
      longest = std::max(longest, grid::powerAbove(radius));
  // With a margin for the rounding of block positions.
  return 2 * grid::block_edge * longest * (1 + 1e-6);
}

std::string_view
gridInstructionSet()
{
  return grid::sweepKernels().target;
}

} // namespace linelet
