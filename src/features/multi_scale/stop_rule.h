// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <linelet/features/multi_scale_settings.h>
#include <linelet/search/neighbor_search.h>
#include <linelet/support/progress_monitor.h>

namespace linelet {

/** \brief Drops the radii after the first at which the factors of all points have
 * converged, as set by MultiScaleSettings::stop_change.
 * \param[in] search over \a surface; null: an engine of linelet */
void
applyStopRule(const NeighborSearch* search,
              const Points& surface,
              const MultiScaleSettings& settings,
              std::vector<double>& radii,
              ProgressMonitor* monitor);

} // namespace linelet
