// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "multi_scale_engine.h"

#include "features/simd_grid/order/reach.h"

#include <algorithm>
#include <atomic>
#include <limits>

namespace linelet::grid {

namespace {

// Blocks hold that many points, or are as wide as float allows.
constexpr double least_crowding = 16;
constexpr double widest_block = 4;

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
                                   int threads)
    : surface_(surface),
      unit_(std::min(largest_radius, reachOf(surface, queries))),
      threads_(threads)
{
  Point low = Point::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const Point& point : surface)
    if (point.allFinite()) {
      low = low.cwiseMin(point);
      high = high.cwiseMax(point);
    }
  // Neighbors lie in the next block at most, for all rounding of its place.
  double edge = unit_ * (1 + 1e-6);
  if (!(low.x() <= high.x()) || !BlockFrame::fits(low, high, edge))
    return;
  const auto sort = [&] {
    surface_order_.reset();
    frame_ = std::make_unique<BlockFrame>(low, high, edge);
    surface_order_ = std::make_unique<BlockOrder>(surface, nullptr, *frame_, threads);
  };
  sort();
  while (surface_order_->crowding() < least_crowding &&
         edge * 2 <= widest_block * unit_) {
    edge *= 2;
    sort();
  }
  groups_ = std::make_unique<PointGroups>(*surface_order_, threads);
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
#pragma omp parallel num_threads(threads_)
  {
    MultiScaleSweep sweep(job, make_visitor());
#pragma omp for schedule(dynamic)
    for (std::ptrdiff_t p = 0; p < count; ++p) {
      if (stop)
        continue;
      const MultiScalePiece& piece = pieces[static_cast<std::size_t>(p)];
      sweep(piece);
      if (monitor != nullptr) {
        monitor->advance(piece.end - piece.begin);
        if (monitor->canceled())
          stop = true;
      }
    }
  }
  if (stop)
    throw Canceled();
}

} // namespace linelet::grid
