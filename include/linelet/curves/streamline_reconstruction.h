// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <linelet/curves/curve_network.h>
#include <linelet/curves/streamline_settings.h>
#include <linelet/search/neighbor_search.h>
#include <linelet/support/points.h>
#include <linelet/support/progress_monitor.h>
#include <linelet/support/visibility.h>

namespace LINELET_PUBLIC linelet {

/** \brief Curves by line-lets that follow the multi-scale neighborhood tensor: the
 * method of Ritter, Schiffner, Harders 2021.
 *
 * Multi-scale features of all points; start points by score; from each a line-let grows
 * both ways, all of them one step at a time, until its ends leave the points, meet or
 * cross; open ends are cut back, stumps are dropped, and the rest is joined. The amount
 * of work is bounded by the number of points, and the result does not depend on the
 * number of threads.
 * \param[in] points any points; those with a coordinate that is not finite are left out
 * \param[in] monitor notified of the stages "shape" (the features) and "curves"
 * \return curves; none if the cloud has no scale (fewer than two distinct points)
 * \throws std::invalid_argument for a parameter out of range, Canceled */
CurveNetwork
reconstructPublished(const Points& points,
                     const StreamlineSettings& settings = {},
                     ProgressMonitor* monitor = nullptr);

/** \brief The same, with neighbors from \a search over \a points. */
CurveNetwork
reconstructPublished(const NeighborSearch& search,
                     const Points& points,
                     const StreamlineSettings& settings = {},
                     ProgressMonitor* monitor = nullptr);

} // namespace linelet
