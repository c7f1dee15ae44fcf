// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <linelet/curves/curve_network.h>
#include <linelet/search/neighbor_search.h>
#include <linelet/support/points.h>
#include <linelet/support/progress_monitor.h>
#include <linelet/support/visibility.h>

namespace LINELET_PUBLIC linelet {

/** \brief Properties of a whole cloud, so that curves are found in each of its parts as
 * in all of it. */
struct CloudTraits {
  double scale_unit = 0;      ///< D, unit of the points
  double linear_share = 0;    ///< share of the points with a linear neighborhood
  double points = 0;          ///< number of points; 0: the traits are unknown
  Point low = Point::Zero();  ///< corners of the box around them
  Point high = Point::Zero(); ///< likewise
};

/** \brief The traits of \a points, of which those that are not finite do not count.
 * D is NaN where there are not two. */
CloudTraits
cloudTraits(const Points& points, unsigned threads = 0);

/** \brief Settings of the refined reconstruction; 0 lets it choose. */
struct RefinedSettings {
  /// Steps per trace from its start point; 0: no limit but the number of points
  unsigned max_iterations = 0;
  /// Traces started per connected component of the cloud; 0: until every point that
  /// looks like a curve is explained
  unsigned start_points = 0;
  /// No gap wider than this is bridged, in the unit of the points, and points nearer to
  /// each other than this are one connected component; 0: no such limit, and 5 D. Where
  /// directions agree, gaps of up to 2.5 D or 15 % of the joined length are bridged; in
  /// a scene, hidden stretches of up to 150 spacings of the points.
  double distance_cutoff = 0;
  bool follow_hidden = true; ///< in a scene, join curves across a stretch that hides
                             ///< them, where a parabola continues them
  bool only_stiff = false;   ///< in a scene, leave out curves that turn by more than a
                             ///< few degrees over ten of their points
  unsigned threads = 0;      ///< threads; 0: all
  CloudTraits whole;         ///< of the cloud, if known
};

/** \brief Curves of a noisy cloud: ridges give the topology, a robust refit the
 * geometry.
 *
 * In a scene, where most points lie on no curve, curves are followed through what
 * surrounds them, block by block (\ref CurveBlocks). The rest of this comment is about
 * other clouds.
 *
 * Every connected component of the cloud is processed by itself. Ridges of its smoothed
 * density are traced at several bandwidths; each result is refitted as a mixture of
 * noisy polylines and uniform outliers by expectation maximization under a bending
 * prior with heavy tails, and the Bayesian information criterion picks the best. All
 * lengths follow from the spacing of the points, so the result is equivariant to
 * translation, rotation and scaling; it does not depend on the number of threads.
 * \param[in] points any points; those with a coordinate that is not finite are left out
 * \param[in] settings see \ref RefinedSettings
 * \param[in] monitor told of every finished component of the cloud; may be null
 * \return curves with the number of points that each vertex explains; none where the
 * cloud holds no curve
 * \throws std::invalid_argument for a negative or NaN cutoff
 * \throws Canceled if \a monitor is canceled */
CurveNetwork
reconstructRefined(const Points& points,
                   const RefinedSettings& settings = {},
                   ProgressMonitor* monitor = nullptr);

/** \brief The same, with the spacing of the points (D, and how it varies along the
 * curves) from \a search over \a points. The fit itself needs sums over points in the
 * order of a grid, which no search provides. */
CurveNetwork
reconstructRefined(const NeighborSearch& search,
                   const Points& points,
                   const RefinedSettings& settings = {},
                   ProgressMonitor* monitor = nullptr);

} // namespace linelet
