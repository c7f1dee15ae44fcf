// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <vector>

#include <linelet/support/points.h>

namespace linelet {

/** \brief Points grouped by the cells of a cubic lattice, without empty cells. */
struct OccupiedCells {
  Indices indices; ///< of the points, those of a cell together, ascending
  std::vector<std::size_t> begin; ///< of each cell in these, then the end

  std::size_t
  size() const
  {
    return begin.size() - 1;
  }
};

/** \brief Sorts the finite points among \a points into cells of side \a side. */
OccupiedCells
occupiedCells(const Points& points, double side);

} // namespace linelet
