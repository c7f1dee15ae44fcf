// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "nearest.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tensor_stages.h"

namespace linelet::opencl {

namespace {

constexpr std::size_t probes = 15; // queries by which the first radius is chosen
constexpr int rounds = 4;          // each with twice the radius

/** \brief Median over a few queries of the distance to the wanted point, by brute
 * force. */
double
usualRadius(const Points& surface,
            const Points& queries,
            const Indices& points,
            const Indices& asking,
            const std::vector<cl_uint>& wanted)
{
  std::vector<double> found, squares(points.size());
  for (std::size_t k = 0; k < probes; ++k) {
    const Index query = asking[k * asking.size() / probes];
    std::transform(points.begin(), points.end(), squares.begin(), [&](Index i) {
      return (surface[i] - queries[query]).squaredNorm();
    });
    const std::size_t last = std::min<std::size_t>(wanted[query], squares.size()) - 1;
    const auto at = squares.begin() + static_cast<std::ptrdiff_t>(last);
    std::nth_element(squares.begin(), at, squares.end());
    found.push_back(*at);
  }
  std::sort(found.begin(), found.end());
  return std::sqrt(found[probes / 2]);
}

/** \brief The smallest double whose square is at least \a squared. */
double
rootAbove(double squared)
{
  double root = std::sqrt(squared);
  while (root * root < squared)
    root = std::nextafter(root, std::numeric_limits<double>::infinity());
  return root;
}

} // namespace

std::vector<double>
nearestRadii(Context& context,
             Slabs& slabs,
             const Points& surface,
             const Points& queries,
             const Indices& points,
             const std::vector<cl_uint>& wanted,
             StageTimes& times)
{
  std::vector<double> radii(queries.size(), std::numeric_limits<double>::quiet_NaN());
  Indices asking;
  for (std::size_t i = 0; i < queries.size(); ++i)
    if (wanted[i] > 0 && queries[i].allFinite())
      asking.push_back(static_cast<Index>(i));
  if (points.empty() || asking.empty())
    return radii;
  double reach = 1.2 * usualRadius(surface, queries, points, asking, wanted);
  for (int round = 0; round < rounds && reach > 0 && !asking.empty(); ++round) {
    const std::vector<double> reaches(queries.size(), reach);
    slabs.forEach(points, asking, reaches, [&](const Slab& slab, const Indices& some) {
      Lap lap(context.queue());
      std::vector<cl_uint> numbers;
      numbers.reserve(some.size());
      for (const Index i : some)
        numbers.push_back(wanted[i]);
      const std::vector<double> squares = nearestSquares(context, slab, numbers);
      for (std::size_t i = 0; i < some.size(); ++i)
        radii[some[i]] = rootAbove(squares[i]);
      lap.add(times.nearest);
    });
    asking.erase(std::remove_if(asking.begin(),
                                asking.end(),
                                [&](Index i) { return !std::isnan(radii[i]); }),
                 asking.end());
    reach *= 2;
  }
  return radii;
}

} // namespace linelet::opencl
