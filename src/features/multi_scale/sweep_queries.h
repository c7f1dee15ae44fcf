// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <optional>
#include <vector>

#include <features/scale_sweep.h>
#include <linelet/search/neighbor_search.h>
#include <linelet/search/uniform_grid.h>
#include <linelet/support/threads.h>
#include <support/parallel_failure.h>

namespace linelet {

/** \brief Rows of a quarter of the radius fit a ball well and still hold long runs. */
inline UniformGrid
gridFor(const Points& surface, double largest_radius)
{
  return UniformGrid(surface, largest_radius / 4);
}

/** \brief The neighbors of a sweep: those of a grid, or of any search. */
class SweepNeighbors {
public:
  /** \param[in] search over \a surface; null: a grid is made. Both are kept by
   * reference */
  SweepNeighbors(const Points& surface,
                 double largest_radius,
                 const NeighborSearch* search = nullptr)
      : surface_(surface), search_(search)
  {
    if (search == nullptr)
      grid_.emplace(gridFor(surface, largest_radius));
  }

  /** \brief Calls visit(offset, squared distance) for each within \a radius. */
  template <class Visit>
  void
  forEachOffset(const Point& query, double radius, Visit&& visit) const
  {
    if (grid_) {
      grid_->forEachOffsetWithin(query, radius, visit);
      return;
    }
    thread_local Indices found;
    search_->within(query, radius, found);
    for (const Index i : found) {
      const Point offset = surface_[i] - query;
      visit(offset, offset.squaredNorm());
    }
  }

private:
  const Points& surface_;
  const NeighborSearch* search_;
  std::optional<UniformGrid> grid_;
};

/** \brief Runs the sweep for queries \a begin to \a end; every thread makes its own
 * visitor of (query, sweep). */
template <class Visit>
void
sweepQueries(const SweepNeighbors& neighbors,
             const Points& queries,
             std::size_t begin,
             std::size_t end,
             const std::vector<double>& radii,
             const MultiScaleSettings& settings,
             ProgressMonitor* monitor,
             const Visit& make_visitor)
{
  constexpr std::size_t chunk_size = 16; // queries handed to a thread at once
  std::atomic<bool> canceled{false};
  // No more threads than there are chunks: waking a thread costs more than a few
  // queries.
  const int threads = static_cast<int>(
      std::min((end - begin + chunk_size - 1) / chunk_size,
               static_cast<std::size_t>(threadCount(settings.threads))));
  ParallelFailure failure;
#ifdef _OPENMP
#pragma omp parallel num_threads(std::max(1, threads))
#endif
  {
    std::optional<ScaleSweep> sweep;
    std::optional<decltype(make_visitor())> visit;
    failure.guard([&] {
      sweep.emplace(radii, settings);
      visit.emplace(make_visitor());
    });
#ifdef _OPENMP
#pragma omp for schedule(dynamic, chunk_size)
#endif
    for (std::ptrdiff_t place = static_cast<std::ptrdiff_t>(begin);
         place < static_cast<std::ptrdiff_t>(end);
         ++place) {
      if (canceled)
        continue;
      const auto query = static_cast<std::size_t>(place);
      failure.guard([&] {
        sweep->clear();
        neighbors.forEachOffset(
            queries[query], radii.back(), [&](const Point& offset, double squared) {
              sweep->add(offset, squared);
            });
        sweep->run();
        (*visit)(query, *sweep);
        if (monitor != nullptr) {
          monitor->advance(1);
          if (monitor->canceled())
            canceled = true;
        }
      });
    }
  }
  failure.rethrow();
  if (canceled)
    throw Canceled();
}

} // namespace linelet
