// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/features/tensor_search.h>

#include <algorithm>
#include <atomic>

#include <linelet/support/threads.h>

#include "support/parallel_failure.h"

namespace linelet {

namespace {

bool
isBefore(const Point& a, const Point& b)
{
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
}

/** \brief Makes records one by one; one maker per thread. */
class RecordMaker {
public:
  RecordMaker(const NeighborSearch& search,
              const Points& surface,
              const TensorSettings& settings,
              const NeighborhoodSizes& sizes)
      : search_(search), surface_(surface), settings_(settings), sizes_(sizes)
  {
  }

  PointDistributionTensor
  operator()(const Point& query, std::size_t i)
  {
    if (!query.allFinite())
      return unknownTensor(0);
    const double radius = find(query, i);
    if (found_.empty())
      return unknownTensor(0);
    offsets_.resize(found_.size());
    for (std::size_t n = 0; n < found_.size(); ++n)
      offsets_[n] = surface_[found_[n]] - query;
    // A piece of a cloud has its points in another order than the whole, and their sum
    // would round otherwise. Pieces have no nearest neighbors.
    if (!isNearest())
      std::sort(offsets_.begin(), offsets_.end(), isBefore);
    return tensorOf(offsets_, radius, settings_);
  }

private:
  bool
  isNearest() const
  {
    return settings_.k > 0 || !sizes_.counts.empty();
  }

  double
  find(const Point& query, std::size_t i)
  {
    found_.clear();
    if (isNearest()) {
      const std::size_t k = settings_.k > 0 ? settings_.k : sizes_.counts[i];
      return search_.nearest(query, k, found_);
    }
    const double radius = settings_.radius > 0 ? settings_.radius : sizes_.radii[i];
    if (isRadius(radius))
      search_.within(query, radius, found_);
    return radius;
  }

  const NeighborSearch& search_;
  const Points& surface_;
  const TensorSettings& settings_;
  const NeighborhoodSizes& sizes_;
  Indices found_;
  Points offsets_;
};

} // namespace

std::vector<PointDistributionTensor>
estimateTensors(const NeighborSearch& search,
                const Points& surface,
                const Points& queries,
                const TensorSettings& settings,
                const NeighborhoodSizes& sizes,
                ProgressMonitor* monitor)
{
  validate(settings, sizes, queries.size());
  std::vector<PointDistributionTensor> records(queries.size());
  if (monitor != nullptr)
    monitor->begin("tensor", queries.size());
  constexpr std::size_t block = 512;
  const auto blocks = static_cast<std::ptrdiff_t>((queries.size() + block - 1) / block);
  std::atomic<bool> stop{false};
  ParallelFailure failure;
#pragma omp parallel num_threads(threadCount(settings.threads))
  {
    RecordMaker make(search, surface, settings, sizes);
#pragma omp for schedule(dynamic)
    for (std::ptrdiff_t b = 0; b < blocks; ++b) {
      if (stop)
        continue;
      const std::size_t begin = static_cast<std::size_t>(b) * block;
      const std::size_t end = std::min(begin + block, queries.size());
      failure.guard([&] {
        for (std::size_t i = begin; i < end; ++i) {
          records[i] = make(queries[i], i);
          if (monitor != nullptr && monitor->canceled())
            break; // neighborhoods may be the whole cloud
        }
        if (monitor != nullptr) {
          monitor->advance(end - begin);
          if (monitor->canceled())
            stop = true;
        }
      });
    }
  }
  failure.rethrow();
  if (stop)
    throw Canceled();
  return records;
}

} // namespace linelet
