// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <limits>
#include <optional>

#include <linelet/search/neighbor_search.h>
#include <linelet/search/uniform_grid.h>
#include <linelet/support/points.h>

namespace linelet {

/** \brief Neighbor search for line-lets among the points of a cloud: by a grid, or by a
 * search that the caller gave. Queries are thread-safe. */
class CloudNeighbors {
public:
  static constexpr Index none = UniformGrid::none;

  /** \param[in] points kept by reference
   * \param[in] usual_radius the most frequent radius
   * \param[in] search over \a points, kept by reference; null: a grid is made */
  CloudNeighbors(const Points& points,
                 double usual_radius,
                 const NeighborSearch* search = nullptr)
      : points_(points), search_(search)
  {
    if (search == nullptr)
      grid_.emplace(points, usual_radius);
  }

  /** \brief Calls visit(index, squared distance) for every point within \a radius. */
  template <class Visit>
  void
  forEachWithin(const Point& query, double radius, Visit&& visit) const
  {
    if (grid_) {
      grid_->forEachWithin(query, radius, visit);
      return;
    }
    thread_local Indices found;
    search_->within(query, radius, found);
    for (const Index i : found)
      visit(i, (points_[i] - query).squaredNorm());
  }

  std::size_t
  countWithin(const Point& query, double radius) const
  {
    if (grid_)
      return grid_->countWithin(query, radius);
    thread_local Indices found;
    search_->within(query, radius, found);
    return found.size();
  }

  /** \brief The nearest point within \a most, or \ref none; ties go to the lowest
   * index. */
  Index
  nearest(const Point& query, double most) const
  {
    if (grid_)
      return grid_->nearest(query, most);
    thread_local Indices found;
    search_->nearest(query, 1, found);
    return !found.empty() &&
                   (points_[found.front()] - query).squaredNorm() <= most * most
               ? found.front()
               : none;
  }

  /** \brief The search that the caller gave, or null. */
  const NeighborSearch*
  search() const
  {
    return search_;
  }

private:
  const Points& points_;
  const NeighborSearch* search_;
  std::optional<UniformGrid> grid_;
};

} // namespace linelet
