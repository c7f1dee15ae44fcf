// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <linelet/features/cloud_piece.h>
#include <linelet/features/multi_scale_settings.h>
#include <linelet/features/multi_scale_types.h>
#include <linelet/features/scale_engine.h>
#include <linelet/search/neighbor_search.h>
#include <linelet/support/points.h>
#include <linelet/support/progress_monitor.h>
#include <linelet/support/visibility.h>

namespace LINELET_PUBLIC linelet {

/** \brief Radii that \a settings ask for on \a surface, the stop rule applied.
 * \return with scale_unit and radii set, without shapes
 * \throws std::invalid_argument if a parameter is out of range, or if D is needed and
 * the points have none */
MultiScaleShapes
multiScaleRadii(const Points& surface,
                const MultiScaleSettings& settings,
                ProgressMonitor* monitor = nullptr);

/** \brief The same, with neighbors from \a search over \a surface. */
MultiScaleShapes
multiScaleRadii(const NeighborSearch& search,
                const Points& surface,
                const MultiScaleSettings& settings,
                ProgressMonitor* monitor = nullptr);

/** \brief The multi-scale shape feature (Ritter, Schiffner, Harders 2021): the shape of
 * the neighborhood of every query at a sequence of radii, and the scale that suits
 * curve reconstruction best.
 *
 * One search at the largest radius serves all scales. The tensor at radius r is that of
 * the points with d <= r; scales with fewer than two neighbors away from the query are
 * not defined. Nothing is kept per scale: \a sink receives the graphs as they are
 * computed. The result does not depend on the number of threads.
 *
 * \param[in] surface points among which neighbors are sought; those with a coordinate
 * that is not finite are left out
 * \param[in] queries where the feature is computed; NaN for one that is not finite. A
 * query that should count as its own neighbor must be in \a surface as well
 * \throws std::invalid_argument as \ref multiScaleRadii; Canceled */
MultiScaleShapes
multiScaleShapes(const Points& surface,
                 const Points& queries,
                 const MultiScaleSettings& settings = {},
                 const ShapeGraphSink& sink = {},
                 ProgressMonitor* monitor = nullptr);

/** \brief The same, with neighbors from \a search over \a surface; the engine of \a
 * settings has no effect. */
MultiScaleShapes
multiScaleShapes(const NeighborSearch& search,
                 const Points& surface,
                 const Points& queries,
                 const MultiScaleSettings& settings = {},
                 const ShapeGraphSink& sink = {},
                 ProgressMonitor* monitor = nullptr);

/** \brief The same for the points of a piece of a cloud: \a points also holds all those
 * within \ref multiScaleMargin of it.
 * \param[in] settings with radii, and the engine that the whole cloud would use
 * \return with a shape for each point of the piece, in order
 * \throws std::invalid_argument without radii, or with a stop rule; Canceled */
MultiScaleShapes
pieceShapes(const Points& points,
            const CloudPiece& piece,
            const MultiScaleSettings& settings,
            ProgressMonitor* monitor = nullptr);

/** \brief How far around a piece its points must be known. */
double
multiScaleMargin(const std::vector<double>& radii);

} // namespace linelet
