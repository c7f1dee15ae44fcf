// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <new>
#include <vector>

#include <linelet/support/points.h>

#include "point_passes.h"
#include "support/huge_pages.h"

namespace linelet::clustering {

/** \brief The cells that one thread's points lie in, numbered as they are first met:
 * one pass over the points finds them and sums their members, and memory access is as
 * local as the points are in space, however fine the grid. */
class TouchedCells {
public:
  /** \brief Whether a grid with this many keys is small enough for one number each. */
  static bool
  suit(std::uint64_t keys, std::size_t points)
  {
    constexpr std::uint64_t few = 1U << 24;
    return keys <= (points > few ? points : few);
  }

  /** \param[in] all number of keys
   * \param[in] points number of points */
  TouchedCells(std::uint64_t all, std::size_t points)
      // Pages of cells that are never touched are never filled.
      : numbers_(static_cast<Index*>(std::calloc(all, sizeof(Index))))
  {
    if (numbers_ == nullptr)
      throw std::bad_alloc();
    constexpr std::size_t points_of_cell = 8; // with fewer, the lists grow
    reserveHuge(sums, points / points_of_cell);
    reserveHuge(keys, points / points_of_cell);
  }

  /** \brief The number of the cell with this key. */
  Index
  number(std::uint64_t key)
  {
    Index& next = numbers_[key];
    if (next == 0) {
      keys.push_back(key);
      sums.emplace_back();
      next = static_cast<Index>(keys.size());
    }
    return next - 1;
  }

  std::vector<std::uint64_t> keys; ///< of the cells, by their numbers
  std::vector<CellSums> sums;

private:
  struct Free {
    void
    operator()(Index* numbers) const
    {
      std::free(numbers);
    }
  };
  std::unique_ptr<Index[], Free> numbers_; // one more; 0: not met
};

} // namespace linelet::clustering
