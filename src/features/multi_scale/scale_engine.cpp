// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/features/scale_engine.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <features/simd_grid/kernels/multi_scale_kernels.h>

namespace linelet {

namespace {

/** \brief Microseconds per query of the engines, without sorting the points. */
struct ScaleCost {
  double grid, sweep;
};

/** \brief Costs as measured on lines and planes of 300 to 20,000 points with
 * 6 to 1,900 neighbors, Fermi-Dirac weights around the query: right within a factor of
 * two; constant weights cost less and other centroids more, on both.
 * \param[in] thinness points of the surface per query
 * \param[in] neighbors of a query within the largest radius */
ScaleCost
scaleCost(double thinness, double neighbors)
{
  // A leaf of the grid tests every point that any of its queries reaches.
  const double reached = std::sqrt(neighbors) +
                         std::sqrt(static_cast<double>(grid::leaf_queries) * thinness);
  return {0.3 + 0.0015 * reached * reached, 0.5 + 0.04 * neighbors};
}

/** \brief Neighbors within \a radius, averaged over some queries. */
double
sampledNeighbors(const Points& surface, const Points& queries, double radius)
{
  constexpr std::size_t samples = 16;
  std::size_t neighbors = 0;
  for (std::size_t i = 0; i < samples; ++i) {
    const Point& query = queries[queries.size() * i / samples];
    neighbors += static_cast<std::size_t>(
        std::count_if(surface.begin(), surface.end(), [&](const Point& point) {
          return (point - query).squaredNorm() <= radius * radius;
        }));
  }
  return static_cast<double>(neighbors) / samples;
}

} // namespace

ScaleEngine
chosenScaleEngine(const Points& surface,
                  const Points& queries,
                  double largest_radius,
                  const MultiScaleSettings& settings)
{
  // Few points are fast enough in double.
  constexpr std::size_t least_points = 1000, least_queries = 256;
  if (settings.engine != ScaleEngine::Auto)
    return settings.engine;
  if (queries.size() < least_queries || surface.size() < least_points)
    return ScaleEngine::Sweep;
  // Where queries are as dense as points, the grid takes half to a twentieth of the
  // time, less with more neighbors.
  const double thinness =
      static_cast<double>(surface.size()) / static_cast<double>(queries.size());
  if (thinness <= 10)
    return ScaleEngine::Grid;
  const ScaleCost cost =
      scaleCost(thinness, sampledNeighbors(surface, queries, largest_radius));
  return cost.grid < cost.sweep ? ScaleEngine::Grid : ScaleEngine::Sweep;
}

} // namespace linelet
