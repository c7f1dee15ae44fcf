// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/search/scale_unit.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_int_distribution.hpp>

#include <linelet/search/uniform_grid.h>
#include <linelet/support/threads.h>

namespace linelet {

namespace {

/** \brief Moves \a count random elements to the front (Fisher and Yates, cut short). */
void
chooseRandomly(Indices& indices, std::size_t count, unsigned seed)
{
  boost::random::mt19937 random(seed);
  for (std::size_t i = 0; i < count; ++i) {
    boost::random::uniform_int_distribution<std::size_t> rest(i, indices.size() - 1);
    std::swap(indices[i], indices[rest(random)]);
  }
}

/** \brief About three times the distance of neighbours on a surface that fills the two
 * longer sides of the box of some points, or on a line along the longest: what a row of
 * a grid is to be wide for few nearest points. */
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

} // namespace

double
scaleUnit(const Points& points, std::size_t sample, unsigned seed, unsigned threads)
{
  constexpr std::size_t neighbours = 6;
  Indices chosen;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points[i].allFinite())
      chosen.push_back(static_cast<Index>(i));
  if (chosen.size() < 2)
    return std::numeric_limits<double>::quiet_NaN();
  const UniformGrid grid(points, rowSize(points, chosen));
  if (sample != 0 && sample < chosen.size()) {
    chooseRandomly(chosen, sample, seed);
    chosen.resize(sample);
  }

  std::vector<double> distances(chosen.size());
  const std::ptrdiff_t count = static_cast<std::ptrdiff_t>(chosen.size());
#pragma omp parallel num_threads(threadCount(threads))
  {
#pragma omp for schedule(dynamic, 64)
    for (std::ptrdiff_t i = 0; i < count; ++i) {
      // The point itself, or one in its place, is the nearest of all.
      const std::size_t at = static_cast<std::size_t>(i);
      const Point& point = points[chosen[at]];
      distances[at] =
          (points[grid.nearestK(point, neighbours + 1).back()] - point).norm();
    }
  }
  const auto middle = distances.begin() + (count - 1) / 2;
  std::nth_element(distances.begin(), middle, distances.end());
  return *middle;
}

} // namespace linelet
