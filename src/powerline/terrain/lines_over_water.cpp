// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/terrain/lines_over_water.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <vector>

#include <linelet/support/threads.h>

#include "powerline/terrain/ground_raster.h"

namespace linelet::powerline {

namespace {

constexpr double surface_part = 0.7; // of the usual share of a surface around terrain
// Smallest typical share of a surface around cells, for there to be a surface at all.
constexpr double least_surface = 0.5;
constexpr float unknown = std::numeric_limits<float>::quiet_NaN();

// For the quarter of its surroundings that fits a cell best, the share of a surface
// that it lies on: cells with returns, at heights that terrain can have there.
float
surfaceAround(const Ground& g, int column, int row)
{
  constexpr int angles = 16, quarter = angles / 4 + 1;
  constexpr std::array<int, 4> radii = {largest_opening_radius / 4,
                                        largest_opening_radius / 2,
                                        3 * largest_opening_radius / 4,
                                        largest_opening_radius};
  const auto at = [&](int c, int r) {
    return g.heights[static_cast<std::size_t>(r) * static_cast<std::size_t>(g.columns) +
                     static_cast<std::size_t>(c)];
  };
  const float height = at(column, row);
  std::array<int, angles> fits{};
  for (int k = 0; k < angles; ++k)
    for (const int radius : radii) {
      const double angle = k * 2 * M_PI / angles;
      const int c = column + static_cast<int>(std::lround(radius * std::cos(angle)));
      const int r = row + static_cast<int>(std::lround(radius * std::sin(angle)));
      if (c < 0 || r < 0 || c >= g.columns || r >= g.rows)
        continue;
      // NaN if there is no return, so never near.
      if (std::abs(at(c, r) - height) <=
          terrain_noise + terrain_slope * g.cell * radius)
        ++fits[static_cast<std::size_t>(k)];
    }
  int best = 0;
  for (int k = 0; k < angles; ++k) {
    int sum = 0;
    for (int more = 0; more < quarter; ++more)
      sum += fits[static_cast<std::size_t>((k + more) % angles)];
    best = std::max(best, sum);
  }
  return static_cast<float>(best) / static_cast<float>(quarter * radii.size());
}

// Of every cell with a return.
std::vector<float>
surfacesAround(const Ground& ground, unsigned threads)
{
  std::vector<float> share(ground.heights.size(), unknown);
  const auto cells = static_cast<std::ptrdiff_t>(share.size());
#pragma omp parallel for schedule(static) num_threads(threadCount(threads))
  for (std::ptrdiff_t i = 0; i < cells; ++i)
    if (!std::isnan(ground.heights[static_cast<std::size_t>(i)]))
      share[static_cast<std::size_t>(i)] =
          surfaceAround(ground,
                        static_cast<int>(i % ground.columns),
                        static_cast<int>(i / ground.columns));
  return share;
}

} // namespace

void
removeLinesOverWater(Ground& ground, unsigned threads, const ProgressMonitor* monitor)
{
  std::vector<float> share = surfacesAround(ground, threads), usual;
  std::copy_if(share.begin(), share.end(), std::back_inserter(usual), [](float s) {
    return !std::isnan(s);
  });
  if (usual.empty())
    return;
  const auto middle = usual.begin() + static_cast<std::ptrdiff_t>(usual.size() / 2);
  std::nth_element(usual.begin(), middle, usual.end());
  if (static_cast<double>(*middle) < least_surface)
    return; // a pylon and its wires, as a drone sees them
  const auto least = static_cast<float>(surface_part) * *middle;
  // Parallel wires look like a surface to each other, so they are removed from the
  // edges inward.
  for (bool any = true; any; share = surfacesAround(ground, threads)) {
    throwIfCanceled(monitor);
    any = false;
    for (std::size_t i = 0; i < share.size(); ++i)
      if (share[i] < least) {
        ground.heights[i] = unknown;
        any = true;
      }
  }
}

} // namespace linelet::powerline
