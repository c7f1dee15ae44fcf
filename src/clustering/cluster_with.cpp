// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "cluster_with.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>

#include <linelet/support/threads.h>

#include "cell_faces.h"
#include "empty_cell_normals.h"
#include "frame_around.h"
#include "leaf_for_count.h"
#include "moves.h"
#include "support/huge_pages.h"

namespace linelet::clustering {

namespace {

/** \brief The field as integers over its range. */
std::vector<std::int32_t>
integersOf(const std::vector<double>& field)
{
  double low = 0, high = 0;
  bool any = false;
  for (const double value : field)
    if (std::isfinite(value)) {
      low = any ? std::min(low, value) : value;
      high = any ? std::max(high, value) : value;
      any = true;
    }
  constexpr double full = 1 << 30;
  const double scale = high > low ? full / (high - low) : 0;
  std::vector<std::int32_t> integers;
  integers.reserve(field.size());
  for (const double value : field)
    integers.push_back(std::isfinite(value) ? static_cast<std::int32_t>(
                                                  std::lrint((value - low) * scale))
                                            : no_value);
  return integers;
}

/** \brief The slots behind the faces of every cell, where both hold points. */
Indices
neighborsOf(const CellDirectory& directory,
            const std::vector<Cell>& cells,
            const std::vector<CellSums>& sums,
            int threads)
{
  Indices neighbors(cells.size() * faces, CellDirectory::none);
#pragma omp parallel for num_threads(threads)
  for (std::ptrdiff_t k = 0; k < static_cast<std::ptrdiff_t>(cells.size()); ++k) {
    const auto slot = static_cast<std::size_t>(k);
    for (std::uint32_t face = 0; face < faces && sums[slot].count > 0; ++face) {
      Cell cell = cells[slot];
      cell[face / 2] += face % 2 == 0 ? -1 : 1;
      const Index other = directory.find(cell);
      if (other != CellDirectory::none && sums[other].count > 0)
        neighbors[slot * faces + face] = other;
    }
  }
  return neighbors;
}

std::vector<CellOrigin>
originsOf(const CellFrame& frame,
          const std::vector<Cell>& cells,
          std::size_t points,
          int threads)
{
  const double units = std::ldexp(1., offsetBits(points));
  std::vector<CellOrigin> origins;
  reserveHuge(origins, cells.size());
  origins.resize(cells.size());
#pragma omp parallel for num_threads(threads)
  for (std::ptrdiff_t k = 0; k < static_cast<std::ptrdiff_t>(cells.size()); ++k) {
    const Cell& cell = cells[static_cast<std::size_t>(k)];
    CellOrigin& origin = origins[static_cast<std::size_t>(k)];
    const Point middle = frame.middle(cell), reach = frame.reach(cell);
    for (std::size_t a = 0; a < 3; ++a) {
      origin.middle[a] = middle[static_cast<Eigen::Index>(a)];
      origin.scale[a] = 1 / reach[static_cast<Eigen::Index>(a)] * units;
    }
  }
  return origins;
}

std::vector<CellPlane>
planesOf(const std::vector<CellSums>& sums,
         const std::vector<CellOrigin>& origins,
         int threads)
{
  std::vector<CellPlane> planes(sums.size());
#pragma omp parallel for num_threads(threads) schedule(dynamic, 1024)
  for (std::ptrdiff_t k = 0; k < static_cast<std::ptrdiff_t>(sums.size()); ++k) {
    const auto slot = static_cast<std::size_t>(k);
    planes[slot] = planeOf(sums[slot], origins[slot]);
  }
  return planes;
}

/** \brief Moves points; \a sums are those of the cells at first. */
void
move(PointPasses& passes,
     const ClusterSettings& settings,
     const Indices& neighbors,
     const std::vector<CellOrigin>& origins,
     const std::vector<CellSums>& sums,
     int threads,
     ProgressMonitor* monitor)
{
  passes.setNeighbors(neighbors);
  if (settings.move_by == MoveRule::Population) {
    std::vector<std::int64_t> populations;
    populations.reserve(sums.size());
    for (const CellSums& sum : sums)
      populations.push_back(sum.count);
    passes.moveBySteps(populationShifts(
        passes.borderCounts(), std::move(populations), neighbors, settings.moves));
    return;
  }
  for (unsigned pass = 0; pass < settings.moves; ++pass) {
    throwIfCanceled(monitor);
    if (settings.move_by == MoveRule::Field) {
      std::vector<double> means;
      for (const FieldSum& sum : passes.fieldSums())
        means.push_back(sum.count > 0 ? static_cast<double>(sum.sum) /
                                            static_cast<double>(sum.count)
                                      : std::nan(""));
      passes.moveByField(means);
    }
    else
      passes.moveToPlanes(planesOf(pass == 0 ? sums : passes.sums(), origins, threads));
  }
}

/** \brief Representatives of cells that have members, and the points' numbers for
 * slots replaced by numbers of these. */
Clusters
reduce(PointPasses& passes,
       const std::vector<Cell>& cells,
       const std::vector<CellOrigin>& origins,
       int threads)
{
  Clusters clusters;
  Indices number(cells.size(), Clusters::none);
  const std::vector<CellSums>& sums = passes.sums();
  Index count = 0;
  for (std::size_t slot = 0; slot < sums.size(); ++slot)
    if (sums[slot].count > 0)
      number[slot] = count++;
  reserveHuge(clusters.representatives, count);
  clusters.representatives.resize(count);
#pragma omp parallel for num_threads(threads)
  for (std::ptrdiff_t k = 0; k < static_cast<std::ptrdiff_t>(sums.size()); ++k) {
    const auto slot = static_cast<std::size_t>(k);
    if (number[slot] == Clusters::none)
      continue;
    const CellMoments moments = momentsOf(sums[slot], origins[slot]);
    clusters.representatives[number[slot]] = {moments.mean,
                                              moments.tensor,
                                              static_cast<Index>(sums[slot].count),
                                              cells[slot]};
  }
  clusters.cluster_of = passes.assigned();
  if (count == sums.size())
    return clusters;
#pragma omp parallel for num_threads(threads)
  for (std::ptrdiff_t i = 0;
       i < static_cast<std::ptrdiff_t>(clusters.cluster_of.size());
       ++i) {
    Index& cluster = clusters.cluster_of[static_cast<std::size_t>(i)];
    if (cluster != Clusters::none)
      cluster = number[cluster];
  }
  return clusters;
}

} // namespace

Clusters
clusterWith(const MakePasses& make,
            const Points& points,
            const ClusterSettings& settings,
            const std::vector<double>& field,
            ProgressMonitor* monitor)
{
  validate(settings);
  const bool by_field = settings.move_by == MoveRule::Field && settings.moves > 0;
  if (by_field && field.size() != points.size())
    throw std::invalid_argument("moves by a field need a value of it for each of the " +
                                std::to_string(points.size()) + " points, not " +
                                std::to_string(field.size()));
  if (points.size() >= Clusters::none)
    throw std::invalid_argument("more points than 2^32 - 2 need to be cut into parts");
  const int threads = threadCount(settings.threads);
  const std::unique_ptr<PointPasses> passes =
      make(points, by_field ? integersOf(field) : std::vector<std::int32_t>{}, threads);
  const double leaf = settings.count > 0
                          ? leafForCount(*passes, points, settings, threads)
                          : settings.leaf;
  throwIfCanceled(monitor);
  const CellFrame frame = frameAround(points, settings, leaf, threads);
  CellDirectory directory(frame.cells);
  passes->findHomes(directory, frame, settings.moves > 0 ? settings.border : 0);
  throwIfCanceled(monitor);
  const std::vector<Cell> cells = directory.all();
  const std::vector<CellOrigin> origins =
      originsOf(frame, cells, points.size(), threads);
  passes->setOrigins(origins);
  if (settings.moves > 0) {
    const std::vector<CellSums>& sums = passes->sums();
    const Indices neighbors = neighborsOf(directory, cells, sums, threads);
    move(*passes, settings, neighbors, origins, sums, threads, monitor);
    throwIfCanceled(monitor);
  }
  Clusters clusters = reduce(*passes, cells, origins, threads);
  for (std::size_t a = 0; a < 3; ++a)
    clusters.cells[a] = frame.cells[a];
  clusters.leaf = leaf;
  if (settings.normals == NormalRule::Tensor && settings.faces == CellFaces::None)
    return clusters;
  std::vector<char> is_filled(cells.size(), 0);
  for (const Representative& one : clusters.representatives)
    is_filled[directory.find(one.cell)] = 1;
  if (settings.normals == NormalRule::EmptyCells)
    clusters.normals = emptyCellNormals(
        clusters.representatives, directory, frame, is_filled, threads);
  clusters.faces = cellFaces(settings.faces, clusters, directory, frame, is_filled);
  return clusters;
}

} // namespace linelet::clustering
