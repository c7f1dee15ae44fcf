// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include <linelet/search/neighbor_search.h>
#include <linelet/support/points.h>
#include <linelet/support/visibility.h>

namespace LINELET_PUBLIC linelet {

/** \brief Restricts a search to a subset of its points; results are positions in that
 * subset. */
class SubsetSearch : public NeighborSearch {
public:
  /** \param[in] whole over \a points; kept by reference
   * \param[in] points all of them; kept by reference
   * \param[in] chosen indices into \a points, in any order, repeated or not
   * \throws std::invalid_argument for an index beyond \a points */
  SubsetSearch(const NeighborSearch& whole,
               const Points& points,
               const Indices& chosen);

  void
  within(const Point& query, double radius, Indices& found) const override;

  double
  nearest(const Point& query, std::size_t count, Indices& found) const override;

private:
  /** \brief Calls visit(place) for the places of the chosen points among \a found. */
  template <class Visit>
  void
  forEachPlace(const Indices& found, Visit&& visit) const;

  const NeighborSearch& whole_;
  const Points& points_;
  std::size_t findable_ = 0;  // of all points: those with finite coordinates
  std::vector<Index> begin_;  // by index: the first of its places, and one behind
  std::vector<Index> places_; // by index, then place
};

} // namespace linelet
