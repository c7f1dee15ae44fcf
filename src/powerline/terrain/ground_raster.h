// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <linelet/powerline/ground.h>
#include <linelet/support/points.h>

#include "powerline/terrain/plan_extent.h"

namespace linelet::powerline {

constexpr double ground_cell_size = 2;     // meters
constexpr int largest_opening_radius = 12; // cells: lowers buildings up to 50 m wide
// Steepest rise that an opening must preserve: 45 degrees, at which scree comes to rest
// (angle of repose, 30 to 45 degrees by the size and edges of the grains).
constexpr double terrain_slope = 1;
constexpr double terrain_noise = 0.3; // of heights, meters

/** \brief A raster over \a extent without heights (NaN), with larger cells if there
 * would be far more cells than points; empty if there are no points. */
Ground
emptyGround(const PlanExtent& extent);

/** \brief Index of the cell that \a p lies in, or of the nearest one. */
inline std::size_t
cellOf(const Ground& ground, const Point& p)
{
  const auto place = [](double offset, double cell, int count) {
    return static_cast<std::size_t>(
        std::clamp(std::floor(offset / cell + 0.5), 0.0, count - 1.0));
  };
  return place(p.y() - ground.y, ground.cell, ground.rows) *
             static_cast<std::size_t>(ground.columns) +
         place(p.x() - ground.x, ground.cell, ground.columns);
}

} // namespace linelet::powerline
