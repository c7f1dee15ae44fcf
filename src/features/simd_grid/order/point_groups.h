// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "block_order.h"
#include "point_list.h"

namespace linelet::grid {

/** \brief Consecutive points of a BlockOrder that lie together. */
struct PointGroup {
  std::uint32_t begin; ///< sorted index of the first one
  std::uint32_t size;
  Point center;  ///< their mean
  double radius; ///< distance of the farthest one from it
  Moments about; ///< sums over the points, relative to the center
};

/** \brief The points of a BlockOrder in groups, as it has cut them: what holds for a
 * group need not be tested point by point. 8 bytes per point. */
class PointGroups {
public:
  /** \brief Most points of a group. */
  static constexpr std::size_t most_points = 16;

  PointGroups(const BlockOrder& order, int threads);

  /** \brief Number of the first group of a block; of all groups, for the number of
   * blocks. */
  std::size_t
  begin(std::size_t block) const
  {
    return begin_[block];
  }

  const PointGroup&
  operator[](std::size_t group) const
  {
    return groups_[group];
  }

private:
  /** \brief Appends the groups of the sorted indices from \a begin to \a end. */
  void
  addGroups(std::size_t begin, std::size_t end);

  std::vector<PointGroup> groups_;
  std::vector<std::size_t> begin_; // blocks + 1
};

} // namespace linelet::grid
