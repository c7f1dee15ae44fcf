// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>
#include <cstdint>

#include <linelet/support/points.h>

#include "point_passes.h"

namespace linelet::clustering {

/** \brief The nearest face of a cell, the first of equally near ones, and how far it
 * is, by how far through the cell a point is; \ref inside_cell if that is not nearer
 * than \a border.
 * \param[in] step_scale steps / border */
inline std::uint8_t
nearestFace(const Point& part, double border, double step_scale)
{
  const double x = part.x() - 0.5, y = part.y() - 0.5, z = part.z() - 0.5;
  double farthest = std::abs(x);
  std::uint32_t face = x > 0 ? 1 : 0;
  const bool by_y = std::abs(y) > farthest;
  farthest = by_y ? std::abs(y) : farthest;
  face = by_y ? (y > 0 ? 3 : 2) : face;
  const bool by_z = std::abs(z) > farthest;
  farthest = by_z ? std::abs(z) : farthest;
  face = by_z ? (z > 0 ? 5 : 4) : face;
  const double distance = 0.5 - farthest;
  if (!(distance < border))
    return inside_cell;
  // Rounding may put points slightly outside their cell.
  const auto step =
      static_cast<std::uint32_t>(distance > 0 ? distance * step_scale : 0);
  return static_cast<std::uint8_t>(face * steps + (step < steps ? step : steps - 1));
}

} // namespace linelet::clustering
