// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <linelet/clustering/cluster_settings.h>
#include <linelet/support/points.h>

#include "cell_frame.h"

namespace linelet::clustering {

/** \brief The grid around the finite points, as the settings say; \a leaf, if not 0,
 * replaces theirs.
 * \throws std::invalid_argument if there would be too many cells */
CellFrame
frameAround(const Points& points,
            const ClusterSettings& settings,
            double leaf,
            int threads);

} // namespace linelet::clustering
