// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include <linelet/features/multi_scale_settings.h>
#include <linelet/features/multi_scale_types.h>
#include <linelet/support/progress_monitor.h>

namespace linelet::apps {

/** \brief The shapes of \a points; their graphs are written to the file \a graphs, if
 * any. */
std::vector<MultiScaleShape>
measure(const Points& points,
        const MultiScaleSettings& settings,
        const std::string& graphs,
        ProgressMonitor* monitor);

} // namespace linelet::apps
