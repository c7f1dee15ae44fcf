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

#include <linelet/search/nearest_walk.h>
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

/** \brief About three times the distance of neighbors on a surface that fills the two
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
  constexpr std::size_t neighbors = 6;
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

  constexpr std::size_t block = 256; // of one thread
  std::vector<double> squares;
  const auto blocks = static_cast<std::ptrdiff_t>((chosen.size() + block - 1) / block);
#pragma omp parallel num_threads(threadCount(threads))
  {
    NearestWalk walk(points, grid, neighbors + 1);
    std::vector<double> own;
#pragma omp for schedule(dynamic)
    for (std::ptrdiff_t b = 0; b < blocks; ++b) {
      const std::size_t begin = static_cast<std::size_t>(b) * block;
      const std::size_t end = std::min(begin + block, chosen.size());
      walk(chosen.data() + begin,
           chosen.data() + end,
           [&](Index, const std::vector<UniformGrid::Neighbor>& nearest) {
             own.push_back(nearest.back().first);
           });
    }
#pragma omp critical(linelet_scale_unit)
    squares.insert(squares.end(), own.begin(), own.end());
  }
  const auto middle =
      squares.begin() + static_cast<std::ptrdiff_t>((squares.size() - 1) / 2);
  std::nth_element(squares.begin(), middle, squares.end());
  return std::sqrt(*middle);
}

} // namespace linelet
