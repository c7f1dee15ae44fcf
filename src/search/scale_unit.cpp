// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/search/scale_unit.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include <linelet/search/uniform_grid.h>
#include <linelet/support/threads.h>

#include "finite_points.h"
#include "nearest_walk.h"
#include "random_sample.h"
#include "support/parallel_failure.h"

namespace linelet {

namespace {

constexpr std::size_t neighbors = 6;

/** \brief A row width that suits searches for a few nearest points: about three times
 * the spacing of points spread over the two longer sides of their box, or along the
 * longest. */
double
rowSize(const Points& points, const Indices& finite)
{
  Point low = points[finite.front()], high = low;
  for (const Index i : finite) {
    low = low.cwiseMin(points[i]);
    high = high.cwiseMax(points[i]);
  }
  Point extent = high - low;
  std::sort(extent.data(), extent.data() + 3);
  const double count = static_cast<double>(finite.size());
  const double size =
      3 * std::max(std::sqrt(extent[1] * extent[2] / count), extent[2] / count);
  return size > 0 && std::isfinite(size) ? size : 1;
}

/** \brief The lower of the middle values. */
double
median(std::vector<double>& values)
{
  const auto middle =
      values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

} // namespace

double
scaleUnit(const NeighborSearch& search,
          const Points& points,
          std::size_t sample,
          unsigned seed,
          unsigned threads)
{
  Indices chosen = finiteOnes(points);
  if (chosen.size() < 2)
    return std::numeric_limits<double>::quiet_NaN();
  keepRandomSample(chosen, sample, seed);
  std::vector<double> distances(chosen.size());
  ParallelFailure failure;
#pragma omp parallel for schedule(dynamic, 16) num_threads(threadCount(threads))
  for (std::ptrdiff_t k = 0; k < static_cast<std::ptrdiff_t>(chosen.size()); ++k) {
    thread_local Indices found;
    const auto place = static_cast<std::size_t>(k);
    failure.guard([&] {
      distances[place] = search.nearest(points[chosen[place]], neighbors + 1, found);
    });
  }
  failure.rethrow();
  return median(distances);
}

double
scaleUnit(const Points& points, std::size_t sample, unsigned seed, unsigned threads)
{
  Indices chosen = finiteOnes(points);
  if (chosen.size() < 2)
    return std::numeric_limits<double>::quiet_NaN();
  const UniformGrid grid(points, rowSize(points, chosen));
  keepRandomSample(chosen, sample, seed);

  constexpr std::size_t block = 256; // of one thread
  std::vector<double> squares;
  const auto blocks = static_cast<std::ptrdiff_t>((chosen.size() + block - 1) / block);
  ParallelFailure failure;
#pragma omp parallel num_threads(threadCount(threads))
  {
    std::optional<NearestWalk> walk;
    std::vector<double> own;
    failure.guard([&] { walk.emplace(points, grid, neighbors + 1); });
#pragma omp for schedule(dynamic)
    for (std::ptrdiff_t b = 0; b < blocks; ++b) {
      const std::size_t begin = static_cast<std::size_t>(b) * block;
      const std::size_t end = std::min(begin + block, chosen.size());
      failure.guard([&] {
        (*walk)(chosen.data() + begin,
                chosen.data() + end,
                [&](Index, const std::vector<UniformGrid::Neighbor>& nearest) {
                  own.push_back(nearest.back().first);
                });
      });
    }
#pragma omp critical(linelet_scale_unit)
    failure.guard([&] { squares.insert(squares.end(), own.begin(), own.end()); });
  }
  failure.rethrow();
  return std::sqrt(median(squares));
}

} // namespace linelet
