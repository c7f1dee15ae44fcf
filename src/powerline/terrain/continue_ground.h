// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <linelet/support/progress_monitor.h>

namespace linelet::powerline {

/** \brief Restores terrain that an opening removed: summits, and the upper ends of
 * strips of data with nothing beyond. These continue the plane of the terrain beside
 * them; roofs and crowns do not.
 * \param[in,out] ground heights in meters; NaN where there is no terrain
 * \param[in] lowest the lowest return of every cell, NaN where there is none
 * \param[in] columns, rows of both
 * \param[in] monitor polled; may be null */
void
continueGround(std::vector<float>& ground,
               const std::vector<float>& lowest,
               int columns,
               int rows,
               const ProgressMonitor* monitor);

} // namespace linelet::powerline
