// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include <linelet/search/neighbor_search.h>
#include <linelet/support/points.h>
#include <linelet/support/progress_monitor.h>
#include <linelet/support/visibility.h>
#include <linelet/tensor/centroid.h>
#include <linelet/tensor/weighting.h>

namespace LINELET_PUBLIC linelet {

/** \brief Parameters of \ref shiftToCentroids. */
struct CentroidShiftSettings {
  double radius = 0; ///< of the neighborhoods, unit of the points
  Centroid centroid = Centroid::Mean;
  Weighting weighting = Kernel::QuadraticInverse; ///< of the weighted centroids
  unsigned threads = 0;                           ///< 0: all
};

/** \param[in] radius name of the option for the radius
 * \param[in] prefix of the other names, with its dash */
template <class Visit>
void
describe(CentroidShiftSettings& s,
         const char* radius,
         const std::string& prefix,
         Visit&& visit)
{
  visit(radius,
        s.radius,
        "first move every point to the centroid of its neighbors within this radius; "
        "0: off");
  visit((prefix + "centroid").c_str(), s.centroid, "centroid that points are moved to");
  visit((prefix + "weight").c_str(),
        s.weighting,
        "weighting kernel of that centroid, if it is weighted");
}

/** \brief Moves every point to the centroid of its neighborhood, which reduces noise
 * across curves before the multi-scale feature or a reconstruction.
 *
 * Neighbors (d <= radius) are always those of the unmoved points. Ends of curves recede
 * by about half the radius and bends are cut, so the radius should be little more than
 * the noise. The result does not depend on the number of threads.
 * \param[in] points any; those that are not finite are returned unchanged
 * \throws std::invalid_argument unless the radius is positive and finite; Canceled */
Points
shiftToCentroids(const Points& points,
                 const CentroidShiftSettings& settings,
                 ProgressMonitor* monitor = nullptr);

/** \brief The same, with neighbors from \a search over \a points. */
Points
shiftToCentroids(const NeighborSearch& search,
                 const Points& points,
                 const CentroidShiftSettings& settings,
                 ProgressMonitor* monitor = nullptr);

} // namespace linelet
