// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

namespace linelet::powerline {

/** \brief Opening (erosion, then dilation) with a square of 2 \a radius + 1 cells.
 * \param[in] threads 0: all */
std::vector<float>
openRaster(const std::vector<float>& raster,
           int columns,
           int rows,
           int radius,
           unsigned threads = 0);

} // namespace linelet::powerline
