// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <linelet/features/multi_scale.h>

namespace linelet {

/** \brief Drops the radii behind the first at which the factors of all points have
 * converged, as MultiScaleSettings::stop_change asks for. */
void
applyStopRule(const Points& surface,
              const MultiScaleSettings& settings,
              std::vector<double>& radii,
              ProgressMonitor* monitor);

} // namespace linelet
