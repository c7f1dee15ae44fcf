// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "multi_scale_engine.h"

#include <algorithm>
#include <atomic>
#include <optional>

#include "features/simd_grid/order/reach.h"
#include "support/parallel_failure.h"

namespace linelet::grid {

namespace {

// Edge of a block in largest radii, for any density; see grid_tensor_engine.cpp.
constexpr double block_edge = 1;

/// Queries of one piece of work: few enough to keep all threads busy.
constexpr std::size_t most_queries = 1024;

/// Cuts the queries of a block, where BlockOrder has cut them, into pieces of work.
void
addPieces(std::size_t block,
          std::size_t begin,
          std::size_t end,
          std::vector<MultiScalePiece>& pieces)
{
  if (end - begin <= most_queries) {
    pieces.push_back({block, begin, end});
    return;
  }
  const std::size_t middle = begin + BlockOrder::half(end - begin);
  addPieces(block, begin, middle, pieces);
  addPieces(block, middle, end, pieces);
}

} // namespace

MultiScaleEngine::MultiScaleEngine(const Points& surface,
                                   const Points& queries,
                                   double largest_radius,
                                   int threads,
                                   const CloudPiece* piece)
    : surface_(surface), piece_(piece), threads_(threads)
{
  const Bounds bounds(surface), whole(surface, piece);
  Bounds extent = whole;
  if (&surface != &queries)
    extent.add(queries);
  unit_ = std::min(largest_radius, reachOf(extent));
  // Despite rounding, neighbors are at most one block away.
  const double edge = block_edge * unit_ * (1 + 1e-6);
  if (bounds.empty() || !BlockFrame::fits(whole.low, whole.high, edge))
    return;
  frame_ = std::make_unique<BlockFrame>(bounds.low, bounds.high, edge);
  surface_order_ = std::make_unique<BlockOrder>(surface, nullptr, *frame_, threads);
  groups_ = std::make_unique<PointGroups>(*surface_order_, threads);
}

double
multiScaleGridMargin(double largest_radius)
{
  return 2 * block_edge * largest_radius * (1 + 2e-6);
}

bool
MultiScaleEngine::isWanted(const BlockOrder& order, const MultiScalePiece& part) const
{
  if (piece_ == nullptr)
    return true;
  for (std::size_t i = part.begin; i < part.end; ++i)
    if (order.index(i) >= piece_->begin && order.index(i) < piece_->end)
      return true;
  return false;
}

void
MultiScaleEngine::run(const Points& queries,
                      const Indices* chosen,
                      const std::vector<double>& radii,
                      const MultiScaleSettings& settings,
                      const std::function<LeafVisitor()>& make_visitor,
                      ProgressMonitor* monitor) const
{
  std::unique_ptr<BlockOrder> own;
  if (&queries != &surface_ || chosen != nullptr)
    own = std::make_unique<BlockOrder>(queries, chosen, *frame_, threads_);
  const BlockOrder& order = own != nullptr ? *own : *surface_order_;
  std::atomic<bool> stop{false};
  const MultiScaleJob job{
      *frame_, *surface_order_, *groups_, order, settings, radii, unit_, monitor, stop};

  std::vector<MultiScalePiece> pieces;
  for (std::size_t block = 0; block < order.blocks(); ++block)
    addPieces(block, order.begin(block), order.begin(block + 1), pieces);
  const auto count = static_cast<std::ptrdiff_t>(pieces.size());
  ParallelFailure failure;
#pragma omp parallel num_threads(threads_)
  {
    std::optional<MultiScaleSweep> sweep;
    failure.guard([&] { sweep.emplace(job, make_visitor()); });
#pragma omp for schedule(dynamic)
    for (std::ptrdiff_t p = 0; p < count; ++p) {
      if (stop)
        continue;
      const MultiScalePiece& piece = pieces[static_cast<std::size_t>(p)];
      if (!isWanted(order, piece))
        continue;
      failure.guard([&] {
        (*sweep)(piece);
        if (monitor != nullptr) {
          monitor->advance(piece.end - piece.begin);
          if (monitor->canceled())
            stop = true;
        }
      });
    }
  }
  failure.rethrow();
  if (stop)
    throw Canceled();
}

} // namespace linelet::grid
