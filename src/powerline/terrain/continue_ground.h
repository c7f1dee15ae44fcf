// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <linelet/support/progress_monitor.h>

namespace linelet::powerline {

/** \brief Gives back what an opening took from the terrain: summits, and the upper ends
 * of strips of data, beside which nothing was seen. These go on in the plane of the
 * terrain beside them; roofs and crowns do not.
 * \param[in,out] ground heights in meters; NaN where there is no terrain
 * \param[in] lowest the lowest return of every cell, NaN where there is none
 * \param[in] columns, rows of both
 * \param[in] monitor polled; null: none */
void
continueGround(std::vector<float>& ground,
               const std::vector<float>& lowest,
               int columns,
               int rows,
               const ProgressMonitor* monitor);

} // namespace linelet::powerline
