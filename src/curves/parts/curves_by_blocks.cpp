// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "curves_by_blocks.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>
#include <vector>

#include <linelet/support/threads.h>

#include "curves/network/model_network.h"
#include "curves/ridges/distinct_points.h"
#include "curves/tracking/mixed_reconstruction.h"
#include "support/parallel_failure.h"
#include "support/quiet_monitor.h"

namespace linelet {

namespace {

// In D: how far past a cut the course of a curve is kept.
constexpr double noted = 20;

/** \brief The points that each block uses, in input order. */
std::vector<Indices>
pointsByBlock(const Points& points, const CurveBlocks& blocks)
{
  std::vector<Indices> result(blocks.count());
  for (std::size_t i = 0; i < points.size(); ++i)
    for (const std::size_t block : blocks.around(points[i]))
      result[block].push_back(static_cast<Index>(i));
  return result;
}

} // namespace

CurveNetwork
curvesByBlocks(const Points& points,
               const RefinedSettings& settings,
               ProgressMonitor* monitor)
{
  const CurveBlocks blocks(settings.whole);
  std::vector<Indices> members = pointsByBlock(points, blocks);
  std::vector<std::size_t> order(blocks.count()); // the most work first
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return members[a].size() > members[b].size();
  });
  if (monitor)
    monitor->begin("curves", blocks.count());
  const auto threads = static_cast<std::size_t>(threadCount(settings.threads));
  // Within a block, threads often wait for each other; with fewer blocks than threads,
  // some would be idle.
  const bool side_by_side = blocks.count() >= threads;
  QuietMonitor inner(monitor); // progress is reported per block
  ParallelFailure failure;
  std::vector<CurvePart> parts(blocks.count());
#pragma omp parallel for schedule(dynamic)                                             \
    num_threads(static_cast <int>(threads)) if (side_by_side)
  for (std::size_t k = 0; k < order.size(); ++k)
    failure.guard([&] {
      const std::size_t block = order[k];
      const Indices own = std::move(members[block]);
      parts[block] = ownCurves(pointsAt(points, own), blocks, block, settings, &inner);
      if (monitor)
        monitor->advance(1);
    });
  failure.rethrow();
  return joinBlocks(std::move(parts), settings.whole);
}

CurvePart
ownCurves(const Points& points,
          const CurveBlocks& blocks,
          std::size_t block,
          const RefinedSettings& settings,
          ProgressMonitor* monitor)
{
  Points near;
  std::copy_if(points.begin(), points.end(), std::back_inserter(near), [&](auto& p) {
    return p.allFinite() && blocks.takesPart(p, block);
  });
  if (near.empty())
    return {};
  const double scale_unit = settings.whole.scale_unit;
  const ModelCurves curves =
      mixedCurves(pointsAt(near, distinct(near)), scale_unit, settings, monitor);
  return ownedBy(
      networkOf(curves),
      block,
      [&](const Point& p) { return blocks.owner(p); },
      noted * scale_unit);
}

} // namespace linelet
