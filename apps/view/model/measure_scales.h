// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <linelet/features/multi_scale.h>

#include "neighborhood.h"

namespace linelet::view {

/** \brief The shapes of \a points, like `multiscale --graphs`; their graphs go to
 * \a store, unless it is null or they would take too much memory. */
MultiScaleShapes
measureScales(const Points& points,
              MultiScaleSettings settings,
              GraphStore* store,
              ProgressMonitor* monitor);

} // namespace linelet::view
