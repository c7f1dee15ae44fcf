// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>

#include <linelet/support/points.h>

namespace linelet {

/** \brief Finds the neighbors of a place in a fixed set of points.
 *
 * Whatever stands behind it (a kd-tree, a grid, a `pcl::search::Search`), the answer is
 * the same to the last point: squared distances are computed in double as
 * `(point - query).squaredNorm()`. Points with a coordinate that is not finite are
 * never found. Both functions are thread-safe. */
class NeighborSearch {
public:
  virtual ~NeighborSearch() = default;

  /** \brief The points with d <= \a radius, ascending by index.
   * \param[in] query any place; nothing is found around one that is not finite
   * \param[out] found replaced */
  virtual void
  within(const Point& query, double radius, Indices& found) const = 0;

  /** \brief The \a count points nearest to \a query (all where there are fewer),
   * ascending by index. Among equally distant points the lower indices are taken.
   * \return distance of the farthest of them; 0 where there are none */
  virtual double
  nearest(const Point& query, std::size_t count, Indices& found) const = 0;
};

} // namespace linelet
