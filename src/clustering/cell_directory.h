// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <linelet/support/points.h>
#include <linelet/support/visibility.h>

#include "cell_frame.h"

namespace linelet {
namespace LINELET_PUBLIC clustering {

/** \brief A set of numbers with ranks: one bit each, in words of 32, and the count of
 * all bits before each word. */
struct RankedBits {
  std::vector<std::uint32_t> words, before;
  std::size_t count = 0;

  /** \brief Counts the bits of \ref words. */
  void
  rank();

  void
  add(std::uint64_t number)
  {
    words[number / 32] |= 1U << (number % 32);
  }

  bool
  has(std::uint64_t number) const
  {
    return ((words[number / 32] >> (number % 32)) & 1U) != 0;
  }

  /** \brief How many members are smaller than \a number. */
  std::uint32_t
  smaller(std::uint64_t number) const
  {
    const std::uint32_t lower = words[number / 32] & ((1U << (number % 32)) - 1);
    return before[number / 32] + static_cast<std::uint32_t>(bitCount(lower));
  }

  static int
  bitCount(std::uint32_t bits)
  {
    bits -= (bits >> 1) & 0x55555555U;
    bits = (bits & 0x33333333U) + ((bits >> 2) & 0x33333333U);
    bits = (bits + (bits >> 4)) & 0x0F0F0F0FU;
    return static_cast<int>((bits * 0x01010101U) >> 24);
  }
};

/** \brief Numbers the cells of a grid that hold points, however large the grid: bricks
 * of 8 x 8 x 8 cells that hold any, and the cells within these. The order is that of
 * the bricks, so that neighbors are mostly near each other. */
class CellDirectory {
public:
  static constexpr Index none = ~Index{0};
  static constexpr std::uint32_t brick_cells = 512;

  explicit CellDirectory(const Cell& cells);

  /** \brief Number of the brick of \a cell in the grid. */
  std::uint64_t
  brick(const Cell& cell) const
  {
    return (static_cast<std::uint64_t>(cell[2] / 8) * bricks_[1] +
            static_cast<std::uint64_t>(cell[1] / 8)) *
               bricks_[0] +
           static_cast<std::uint64_t>(cell[0] / 8);
  }

  /** \brief Number of \a cell within its brick. */
  static std::uint32_t
  within(const Cell& cell)
  {
    return static_cast<std::uint32_t>((cell[0] & 7) | ((cell[1] & 7) << 3) |
                                      ((cell[2] & 7) << 6));
  }

  /** \brief Number of \a cell in the grid, brick by brick. */
  std::uint64_t
  keyOf(const Cell& cell) const
  {
    return brick(cell) * brick_cells + within(cell);
  }

  /** \brief Number of all keys. */
  std::uint64_t
  keys() const
  {
    return bricks_[0] * bricks_[1] * bricks_[2] * brick_cells;
  }

  /** \brief Number of the bit of a cell whose brick is marked. */
  std::uint64_t
  bit(std::uint64_t key) const
  {
    return all_marked_
               ? key
               : std::uint64_t{brick_cells} * marked.smaller(key / brick_cells) +
                     key % brick_cells;
  }

  /** \brief Number of slots: cells that hold points. */
  std::size_t
  slots() const
  {
    return occupied.count;
  }

  /** \brief The number of a cell that holds points, by order of keys. */
  Index
  slot(std::uint64_t key) const
  {
    return occupied.smaller(bit(key));
  }

  /** \brief The same for any cell, even outside the grid; \ref none if it has no slot.
   */
  Index
  find(const Cell& cell) const;

  /** \brief All cells that have a slot, in their order. */
  std::vector<Cell>
  all() const;

  RankedBits marked;   ///< bricks that may hold points
  RankedBits occupied; ///< cells of these bricks that do

  /** \brief Marks all bricks, if that is cheap compared with \a points points. */
  bool
  markAll(std::size_t points);

  /** \brief Marks and ranks the bricks and cells with these keys. */
  void
  fillWith(const std::vector<std::vector<std::uint64_t>>& keys);

  const std::array<std::uint64_t, 3>&
  bricks() const
  {
    return bricks_;
  }

private:
  Cell cells_;
  std::array<std::uint64_t, 3> bricks_;
  bool all_marked_ = false;
};

} // namespace clustering
} // namespace linelet
