// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/features/centroid_shift.h>

#include <atomic>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>

#include <linelet/search/uniform_grid.h>
#include <linelet/support/text.h>
#include <linelet/support/threads.h>

#include "support/parallel_failure.h"

namespace linelet {

namespace {

void
check(const CentroidShiftSettings& settings)
{
  if (!(settings.radius > 0) || !std::isfinite(settings.radius))
    throw std::invalid_argument("radius " + textOf(settings.radius) +
                                " of the centroid shift is not positive and finite");
  checkWeightings(settings.centroid, Kernel::Const, settings.weighting);
}

/** \param[in] add_offsets (query, offsets) gathers the neighbors of a place */
template <class AddOffsets>
Points
shifted(const Points& points,
        const CentroidShiftSettings& settings,
        ProgressMonitor* monitor,
        const AddOffsets& add_offsets)
{
  Points moved = points;
  if (monitor != nullptr)
    monitor->begin("centroid shift", points.size());
  std::atomic<bool> canceled{false};
  ParallelFailure failure;
#ifdef _OPENMP
#pragma omp parallel num_threads(threadCount(settings.threads))
#endif
  {
    Points offsets;
#ifdef _OPENMP
#pragma omp for schedule(dynamic, 256)
#endif
    for (std::ptrdiff_t place = 0; place < static_cast<std::ptrdiff_t>(points.size());
         ++place) {
      const auto i = static_cast<std::size_t>(place);
      if (canceled || !points[i].allFinite())
        continue;
      failure.guard([&] {
        offsets.clear();
        add_offsets(points[i], offsets);
        moved[i] += centroid(settings.centroid,
                             offsets,
                             Point::Zero(),
                             settings.radius,
                             settings.weighting);
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
  return moved;
}

} // namespace

Points
shiftToCentroids(const Points& points,
                 const CentroidShiftSettings& settings,
                 ProgressMonitor* monitor)
{
  check(settings);
  const UniformGrid grid(points, settings.radius);
  return shifted(points, settings, monitor, [&](const Point& query, Points& offsets) {
    grid.forEachOffsetWithin(query, settings.radius, [&](const Point& offset, double) {
      offsets.push_back(offset);
    });
  });
}

Points
shiftToCentroids(const NeighborSearch& search,
                 const Points& points,
                 const CentroidShiftSettings& settings,
                 ProgressMonitor* monitor)
{
  check(settings);
  return shifted(points, settings, monitor, [&](const Point& query, Points& offsets) {
    thread_local Indices found;
    search.within(query, settings.radius, found);
    for (const Index i : found)
      offsets.push_back(points[i] - query);
  });
}

} // namespace linelet
