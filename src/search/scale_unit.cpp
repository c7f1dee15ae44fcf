// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/search/scale_unit.h>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_int_distribution.hpp>

#include <linelet/search/kd_tree.h>
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
  if (sample != 0 && sample < chosen.size()) {
    chooseRandomly(chosen, sample, seed);
    chosen.resize(sample);
  }

  const KdTree tree(points);
  std::vector<double> distances(chosen.size());
  const std::ptrdiff_t count = static_cast<std::ptrdiff_t>(chosen.size());
#pragma omp parallel num_threads(threadCount(threads))
  {
    Indices found;
#pragma omp for schedule(dynamic, 64)
    for (std::ptrdiff_t i = 0; i < count; ++i) {
      // The point itself, or one in its place, is the nearest of all.
      const std::size_t at = static_cast<std::size_t>(i);
      distances[at] = tree.nearest(points[chosen[at]], neighbours + 1, found);
    }
  }
  const auto middle = distances.begin() + (count - 1) / 2;
  std::nth_element(distances.begin(), middle, distances.end());
  return *middle;
}

} // namespace linelet
