// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <linelet/search/neighbor_search.h>
#include <linelet/search/uniform_grid.h>
#include <linelet/support/visibility.h>

namespace LINELET_PUBLIC linelet {

/** \brief UniformGrid as a NeighborSearch. */
class GridSearch : public NeighborSearch {
public:
  /** \param[in] points copied
   * \param[in] size width of a cell, best near the most frequent radius
   * \throws std::invalid_argument unless \a size is positive and finite */
  GridSearch(const Points& points, double size) : points_(points), grid_(points, size)
  {
  }

  void
  within(const Point& query, double radius, Indices& found) const override;

  double
  nearest(const Point& query, std::size_t count, Indices& found) const override;

private:
  Points points_; // in input order
  UniformGrid grid_;
};

} // namespace linelet
