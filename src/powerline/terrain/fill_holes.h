// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <vector>

namespace linelet::powerline {

/** \brief How \ref fillHoles computes larger cells. */
enum class Fill {
  Smooth, ///< by the mean of what is known in them
  Low     ///< by its minimum
};

/** \brief Fills the cells of a raster that are NaN from those around, by ever larger
 * cells. A raster without any value is unchanged.
 * \param[in] first_column, first_row position of the raster in the larger one from
 * which larger cells are counted */
void
fillHoles(std::vector<float>& raster,
          int columns,
          int rows,
          Fill fill = Fill::Smooth,
          std::int64_t first_column = 0,
          std::int64_t first_row = 0);

} // namespace linelet::powerline
