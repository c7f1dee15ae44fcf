// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <linelet/support/points.h>

namespace linelet::grid {

/** \brief Cubes of one edge length over the box of a set of points, with a margin of
 * one cube all around, numbered along x first.
 *
 * Their corners are multiples of the edge, wherever the box is: a point is in the same
 * cube whatever other points there are. */
class BlockFrame {
public:
  /** \brief Coordinates of a block. */
  using Cell = std::array<std::int64_t, 3>;

  /** \brief Most blocks along one axis: more would not fit into a key. */
  static constexpr double most_blocks = 2097150;

  /** \param[in] low, high box of the points, finite
   * \param[in] edge positive; see \ref fits */
  BlockFrame(const Point& low, const Point& high, double edge);

  /** \brief Farthest block from the origin: beyond, rounding would move a point by more
   * than the margin of an edge. */
  static constexpr double farthest_block = 1e9;

  /** \brief Whether the box can be cut into blocks of this \a edge. */
  static bool
  fits(const Point& low, const Point& high, double edge);

  /** \brief Block of \a point, finite; false where it lies outside the frame. */
  bool
  locate(const Point& point, Cell& cell) const;

  std::uint64_t
  key(const Cell& cell) const
  {
    return static_cast<std::uint64_t>(cell[0]) |
           static_cast<std::uint64_t>(cell[1]) << bits_[0] |
           static_cast<std::uint64_t>(cell[2]) << (bits_[0] + bits_[1]);
  }

  Cell
  cell(std::uint64_t key) const;

  Point
  center(const Cell& cell) const;

  /** \brief Number of bits of the largest key. */
  int
  keyBits() const
  {
    return bits_[0] + bits_[1] + bits_[2];
  }

  double
  edge() const
  {
    return edge_;
  }

private:
  Cell first_{}; // the block with coordinates 0, on the lattice of all space
  double edge_, inverse_edge_;
  std::array<std::int64_t, 3> counts_{};
  std::array<int, 3> bits_{};
};

/** \brief Points sorted by block, coordinate by coordinate, for vector loads.
 *
 * The points of a block are cut in two across the longest side of their box, these
 * parts again, down to \ref leaf points: see \ref half. Their order is that of their
 * places, not of their indices: only points in one place keep the order they came in.
 *
 * 28 bytes per point, and 16 per block that holds any. */
class BlockOrder {
public:
  /** \brief Most points of a part that is not cut further. */
  static constexpr std::size_t leaf = 8;

  /** \brief How many of \a count points, more than \ref leaf, come before the cut: an
   * even number of leaves, so that they can be taken in pairs. */
  static std::size_t
  half(std::size_t count)
  {
    const std::size_t leaves = (count + leaf - 1) / leaf;
    return count * (leaves == 2 ? 1 : (leaves + 2) / 4 * 2) / leaves;
  }

  /** \brief Entries after the last point that may be read. */
  static constexpr std::size_t padding = 16;

  /** \brief Sorts those of \a points that are finite and lie in the frame.
   * \param[in] chosen ascending indices of the points to sort, or null for all */
  BlockOrder(const Points& points,
             const Indices* chosen,
             const BlockFrame& frame,
             int threads);

  std::size_t
  size() const
  {
    return index_.size();
  }
  std::size_t
  blocks() const
  {
    return keys_.size();
  }
  std::uint64_t
  key(std::size_t block) const
  {
    return keys_[block];
  }
  std::size_t
  begin(std::size_t block) const
  {
    return begin_[block];
  }
  /** \brief First block whose key is not less than \a key.
   * \param[in] hint a block at or shortly before the answer */
  std::size_t
  lowerBound(std::uint64_t key, std::size_t hint) const;

  const double*
  coordinate(int axis) const
  {
    return coordinates_[static_cast<std::size_t>(axis)].data();
  }
  Point
  point(std::size_t sorted_index) const
  {
    return {coordinates_[0][sorted_index],
            coordinates_[1][sorted_index],
            coordinates_[2][sorted_index]};
  }
  /** \brief Input index of the point in \a sorted_index. */
  Index
  index(std::size_t sorted_index) const
  {
    return index_[sorted_index];
  }

private:
  /** \brief A point of a block. */
  struct Entry {
    std::array<float, 3> place; // relative to the block, to compare
    Index index;

    bool
    operator<(const Entry& other) const
    {
      return place != other.place ? place < other.place : index < other.index;
    }
  };

  /** \brief Puts the points with the least coordinates before \a middle; the same ones
   * in whatever order they come.
   * \param[in] low, high bounds of the coordinates */
  static void
  select(
      Entry* begin, Entry* middle, Entry* end, std::size_t axis, float low, float high);

  /** \brief Cuts a run of points in two, and these again. */
  static void
  cut(Entry* begin, Entry* end);

  /** \brief Orders the points of a block and fetches their coordinates. */
  void
  sortBlock(std::size_t block,
            const Points& points,
            const BlockFrame& frame,
            std::vector<Entry>& entries);

  std::array<std::vector<double>, 3> coordinates_;
  Indices index_;
  std::vector<std::uint64_t> keys_;
  std::vector<std::size_t> begin_; // blocks + 1
};

} // namespace linelet::grid
