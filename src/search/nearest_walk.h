// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <linelet/search/uniform_grid.h>

namespace linelet {

/** \brief The nearest points of each of many points, visited by walking from one to its
 * nearest: a neighbor's distance grows by no more than the step, so that few points are
 * tested needlessly. Not thread-safe: use one per thread. */
class NearestWalk {
public:
  /** \param[in] points those of \a grid; both must outlive this
   * \param[in] count neighbors of a point, at least 1 */
  NearestWalk(const Points& points, const UniformGrid& grid, std::size_t count)
      : points_(points), grid_(grid), count_(count), waiting_(points.size(), 0)
  {
  }

  /** \brief Calls visit(index, neighbors) for the points from \a begin to \a end, in
   * any order. Neighbors (fewer if there are fewer) come near to far, ties by index;
   * the first is the point itself or a coincident one. */
  template <class Visit>
  void
  operator()(const Index* begin, const Index* end, Visit&& visit)
  {
    for (const Index* i = begin; i < end; ++i)
      waiting_[*i] = 1;
    for (; begin < end; ++begin) {
      double radius = grid_.rowSize();
      for (Index at = *begin; waiting_[at];) {
        waiting_[at] = 0;
        grid_.nearestK(points_[at], count_, radius, found_);
        visit(at, found_);
        const auto next =
            std::find_if(found_.begin(), found_.end(), [&](const auto& n) {
              return waiting_[n.second] != 0;
            });
        if (next == found_.end())
          break;
        at = next->second;
        radius = (1 + 1e-9) * (std::sqrt(found_.back().first) + std::sqrt(next->first));
      }
    }
  }

private:
  const Points& points_;
  const UniformGrid& grid_;
  std::size_t count_;
  std::vector<char> waiting_; // by index
  std::vector<UniformGrid::Neighbor> found_;
};

} // namespace linelet
