// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <linelet/curves/refined_settings.h>
#include <linelet/search/neighbor_search.h>
#include <linelet/support/points.h>
#include <linelet/support/progress_monitor.h>

#include "curves/ridges/model_curve.h"

namespace linelet {

/** \brief The curves of a cloud that holds hardly anything else, each connected
 * component separately.
 * \param[in] search over \a points, or null */
ModelCurves
componentCurves(const Points& points,
                const NeighborSearch* search,
                double scale_unit,
                const RefinedSettings& settings,
                ProgressMonitor* monitor);

} // namespace linelet
