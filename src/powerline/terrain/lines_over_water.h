// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <linelet/powerline/ground.h>
#include <linelet/support/progress_monitor.h>

namespace linelet::powerline {

/** \brief Sets the cells to NaN whose returns lie on no surface: over water, which
 * returns nothing, these are the wires. A raster that shows no surface at all is
 * unchanged. \param[in] threads 0: all */
void
removeLinesOverWater(Ground& ground, unsigned threads, const ProgressMonitor* monitor);

} // namespace linelet::powerline
