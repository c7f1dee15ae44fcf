// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>

#include <linelet/support/points.h>
#include <linelet/support/visibility.h>

namespace LINELET_PUBLIC linelet {

/** \brief Finds the neighbors of a place in a fixed set of points.
 *
 * All implementations (kd-tree, grid, `pcl::search::Search`) give exactly the same
 * neighbors: squared distances are computed in double as `(point -
 * query).squaredNorm()`. Points with non-finite coordinates are never found. Both
 * functions are thread-safe. */
class NeighborSearch {
public:
  virtual ~NeighborSearch() = default;

  /** \brief The points with d <= \a radius, ascending by index.
   * \param[in] query any place; a non-finite one has no neighbors
   * \param[out] found replaced */
  virtual void
  within(const Point& query, double radius, Indices& found) const = 0;

  /** \brief The \a count points nearest to \a query (all if there are fewer), ascending
   * by index. Among equally distant points the lower indices are taken.
   * \return distance of the farthest of them; 0 if there are none */
  virtual double
  nearest(const Point& query, std::size_t count, Indices& found) const = 0;
};

} // namespace linelet
