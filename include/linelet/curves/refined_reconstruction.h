// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <linelet/curves/curve_network.h>
#include <linelet/search/neighbor_search.h>
#include <linelet/support/points.h>
#include <linelet/support/progress_monitor.h>
#include <linelet/support/visibility.h>

namespace LINELET_PUBLIC linelet {

/** \brief What a cloud is like as a whole, so that curves are looked for in each of its
 * parts as in all of it. */
struct CloudTraits {
  double scale_unit = 0;      ///< D, unit of the points
  double linear_share = 0;    ///< share of the points around which it is linear
  double points = 0;          ///< number of points; 0: nothing is known
  Point low = Point::Zero();  ///< corners of the box around them
  Point high = Point::Zero(); ///< likewise
};

/** \brief The traits of \a points, of which those that are not finite do not count.
 * D is NaN where there are not two. */
CloudTraits
cloudTraits(const Points& points, unsigned threads = 0);

/** \brief What may be set of the refined reconstruction; 0 lets it choose. */
struct RefinedSettings {
  unsigned max_iterations = 0; ///< steps of one trace from its start point; 0: no limit
                               ///< beside the number of points
  unsigned start_points = 0; ///< traces begun per connected component of the cloud; 0:
                             ///< until every point that looks like a curve is explained
  double distance_cutoff =
      0;                     ///< widest gap that is bridged, in the unit of the points;
                             ///< 0: an eighth of the length, where directions agree
  bool follow_hidden = true; ///< in a scene, a curve goes on beyond a stretch that
                             ///< hides it, where a parabola continues it
  unsigned threads = 0;      ///< threads; 0: all
  CloudTraits whole;         ///< of the cloud, if known
};

/** \brief Curves of a noisy cloud: ridges give the topology, a robust refit the
 * geometry.
 *
 * In a scene in which most points are on no curve, curves are followed through what
 * surrounds them, block by block (\ref CurveBlocks). What follows is about the others.
 *
 * Every connected component of the cloud is worked on by itself. Ridges of its smoothed
 * density are traced at several bandwidths; each result is refitted as a mixture of
 * noisy polylines and uniform outliers by expectation maximization under a bending
 * prior with heavy tails, and the Bayesian information criterion picks the best. All
 * lengths follow from the spacing of the points, so the result moves, turns and scales
 * with the input; it does not depend on the number of threads.
 * \param[in] points any points; those with a coordinate that is not finite are left out
 * \param[in] settings see \ref RefinedSettings
 * \param[in] monitor hears of every component of the cloud that is done; may be null
 * \return curves with the number of points that each vertex explains; none where the
 * cloud holds no curve
 * \throws std::invalid_argument for a negative or NaN cutoff
 * \throws Canceled if \a monitor is canceled */
CurveNetwork
reconstructRefined(const Points& points,
                   const RefinedSettings& settings = {},
                   ProgressMonitor* monitor = nullptr);

/** \brief The same, with the spacing of the points (D, and how it varies along the
 * curves) from \a search over \a points. The densities and distances that curves are
 * fitted by are sums over points in the order of a grid, which no search could give. */
CurveNetwork
reconstructRefined(const NeighborSearch& search,
                   const Points& points,
                   const RefinedSettings& settings = {},
                   ProgressMonitor* monitor = nullptr);

} // namespace linelet
