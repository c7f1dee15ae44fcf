// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>

#include <linelet/search/neighbor_search.h>
#include <linelet/support/points.h>
#include <linelet/support/visibility.h>

namespace LINELET_PUBLIC linelet {

/** \brief The scale unit D: the median, over all points or a random subset, of the
 * distance to the 6th nearest other point.
 *
 * \param[in] points those with non-finite coordinates are left out
 * \param[in] sample size of the subset; 0: all points
 * \param[in] seed of the subset; equal seeds give equal subsets
 * \param[in] threads 0: all
 * \return D in the unit of the points; for an even count the lower of the two middle
 * values. With 2 to 6 points the farthest other point stands in for the 6th nearest. 0
 * if more than half of the sampled points coincide with six others; NaN for fewer than
 * 2 points */
double
scaleUnit(const Points& points,
          std::size_t sample = 1024,
          unsigned seed = 1,
          unsigned threads = 0);

/** \brief The same, with neighbors from \a search over \a points. */
double
scaleUnit(const NeighborSearch& search,
          const Points& points,
          std::size_t sample = 1024,
          unsigned seed = 1,
          unsigned threads = 0);

} // namespace linelet
