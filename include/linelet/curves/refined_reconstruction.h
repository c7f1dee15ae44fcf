// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>

#include <linelet/curves/curve_network.h>
#include <linelet/curves/curve_parts.h>
#include <linelet/curves/refined_settings.h>
#include <linelet/search/neighbor_search.h>
#include <linelet/support/points.h>
#include <linelet/support/progress_monitor.h>
#include <linelet/support/visibility.h>

namespace LINELET_PUBLIC linelet {

/** \brief The traits of \a points, ignoring those that are not finite. D is NaN for
 * fewer than two points. */
CloudTraits
cloudTraits(const Points& points, unsigned threads = 0);

/** \brief Curves of a noisy cloud: ridges give the topology, a robust refit the
 * geometry.
 *
 * In a scene, where most points lie on no curve, curves are followed through their
 * surroundings, block by block (\ref CurveBlocks). The rest of this comment is about
 * other clouds.
 *
 * Every connected component of the cloud is processed separately. Ridges of its
 * smoothed density are traced at several bandwidths; each result is refitted as a
 * mixture of noisy polylines and uniform outliers by expectation maximization under a
 * heavy-tailed bending prior, and the Bayesian information criterion picks the best.
 * All lengths follow from the spacing of the points, so the result is equivariant to
 * translation, rotation and scaling; it does not depend on the number of threads.
 * \param[in] points any points; those with a coordinate that is not finite are left out
 * \param[in] settings see \ref RefinedSettings
 * \param[in] monitor notified of every finished component; may be null
 * \return curves with the number of points that each vertex explains; none if the cloud
 * holds no curve
 * \throws std::invalid_argument for a negative or NaN cutoff
 * \throws Canceled if \a monitor is canceled */
CurveNetwork
reconstructRefined(const Points& points,
                   const RefinedSettings& settings = {},
                   ProgressMonitor* monitor = nullptr);

/** \brief The same, with the spacing of the points (D, and how it varies along the
 * curves) from \a search over \a points. The fit itself sums over points in grid order,
 * which no search provides. */
CurveNetwork
reconstructRefined(const NeighborSearch& search,
                   const Points& points,
                   const RefinedSettings& settings = {},
                   ProgressMonitor* monitor = nullptr);

/** \brief The curves of one block of \ref CurveBlocks, cut to what it owns.
 * \param[in] points of the cloud, in its order: all that the block uses, and possibly
 * others
 * \param[in] settings with the traits of the whole cloud
 * \throws as \ref reconstructRefined */
CurvePart
curvesOfBlock(const Points& points,
              std::size_t block,
              const RefinedSettings& settings,
              ProgressMonitor* monitor = nullptr);

} // namespace linelet
