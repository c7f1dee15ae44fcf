// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/terrain/find_ground.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "powerline/terrain/continue_ground.h"
#include "powerline/terrain/fill_holes.h"
#include "powerline/terrain/ground_raster.h"
#include "powerline/terrain/lines_over_water.h"
#include "powerline/terrain/opening.h"
#include "powerline/terrain/refine_ground.h"

namespace linelet::powerline {

namespace {

// Lifts cells far below all but one of their neighbors: multipath returns.
void
repairPits(std::vector<float>& heights, int columns, int rows)
{
  const std::vector<float> old = heights;
  const auto at = [columns](int c, int r) {
    return static_cast<std::size_t>(r) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(c);
  };
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < columns; ++c) {
      std::array<float, 24> around;
      std::size_t count = 0;
      for (int y = std::max(0, r - 2); y <= std::min(rows - 1, r + 2); ++y)
        for (int x = std::max(0, c - 2); x <= std::min(columns - 1, c + 2); ++x)
          if (x != c || y != r)
            around[count++] = old[at(x, y)];
      if (count < 5)
        continue;
      std::nth_element(around.begin(), around.begin() + 3, around.begin() + count);
      if (old[at(c, r)] < around[3] - 2.5F)
        heights[at(c, r)] = around[3];
    }
}

} // namespace

Ground
findGround(const Points& points,
           const std::vector<std::uint8_t>& classes,
           bool use_classes,
           const ProgressMonitor* monitor,
           bool on_surfaces,
           unsigned threads)
{
  const PlanExtent extent = planExtent(points, ground_cell_size);
  throwIfCanceled(monitor);
  Ground g = emptyGround(extent);
  if (g.heights.empty())
    return g;
  const auto fill = [&](std::vector<float>& heights, Fill how) {
    fillHoles(heights,
              g.columns,
              g.rows,
              how,
              std::llround(g.x / g.cell),
              std::llround(g.y / g.cell));
  };

  if (use_classes && std::count(classes.begin(), classes.end(), 2) >= 3) {
    Points terrain;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (classes[i] == 2 && points[i].allFinite() && extent.contains(points[i]))
        terrain.push_back(points[i]);
    for (const Point& p : terrain) {
      float& height = g.heights[cellOf(g, p)];
      height = std::fmin(height, static_cast<float>(p.z()));
    }
    fill(g.heights, Fill::Smooth);
    refineGround(g, extent, terrain, threads);
    return g;
  }

  for (const Point& p : points)
    if (p.allFinite() && extent.contains(p)) {
      float& height = g.heights[cellOf(g, p)];
      height = std::fmin(height, static_cast<float>(p.z()));
    }
  if (on_surfaces)
    removeLinesOverWater(g, threads, monitor);
  // Where nothing was seen the terrain may be low, so that what hangs above stands out.
  throwIfCanceled(monitor);
  std::vector<float> surface = g.heights;
  fill(surface, Fill::Low);
  repairPits(surface, g.columns, g.rows);
  for (std::size_t i = 0; i < surface.size(); ++i)
    if (!std::isnan(g.heights[i]))
      g.heights[i] = surface[i];
  const std::vector<float> lowest = g.heights;
  for (int radius = 1; radius <= largest_opening_radius; ++radius) {
    throwIfCanceled(monitor);
    const std::vector<float> opened =
        openRaster(surface, g.columns, g.rows, radius, threads);
    // Terrain of the steepest slope loses this much more than at the previous radius.
    const float limit = static_cast<float>(terrain_noise + terrain_slope * g.cell);
    for (std::size_t i = 0; i < surface.size(); ++i)
      if (surface[i] > opened[i] + limit)
        g.heights[i] = std::numeric_limits<float>::quiet_NaN();
    surface = opened;
  }
  continueGround(g.heights, lowest, g.columns, g.rows, monitor);
  fill(g.heights, Fill::Smooth);
  throwIfCanceled(monitor);
  refineGround(g, extent, points, threads);
  return g;
}

} // namespace linelet::powerline
