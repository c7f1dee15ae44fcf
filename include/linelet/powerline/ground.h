// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <limits>
#include <vector>

#include <linelet/support/points.h>
#include <linelet/support/visibility.h>

namespace linelet {
namespace LINELET_PUBLIC powerline {

/** \brief Terrain as heights on a square raster, interpolated between its nodes. */
struct Ground {
  double cell = 1;            ///< side of a cell, meters
  double x = 0, y = 0;        ///< center of the first cell
  int columns = 0, rows = 0;  ///< cells along x and y
  std::vector<float> heights; ///< row by row, x fastest; empty if unknown

  /** \brief Height of the terrain at a place, bilinear; beyond the raster, that of its
   * edge; NaN without a raster. */
  double
  heightAt(double at_x, double at_y) const;
};

} // namespace powerline
} // namespace linelet
