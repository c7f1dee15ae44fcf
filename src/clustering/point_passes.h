// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <linelet/support/points.h>
#include <linelet/support/visibility.h>

#include "cell_directory.h"
#include "cell_frame.h"

namespace linelet {
namespace LINELET_PUBLIC clustering {

/** \brief Faces of a cell: -x, +x, -y, +y, -z, +z; f ^ 1 is the face across. */
constexpr std::uint32_t faces = 6;

/** \brief Number of steps into which the distance to a border is quantized. */
constexpr std::uint32_t steps = 8;

/** \brief Code of a point's distance from the border of its cell: face * steps + step,
 * nearest steps first; this value if no border is near. */
constexpr std::uint8_t inside_cell = 255;

/** \brief Origin and unit of the sums over the members of a cell. */
struct CellOrigin {
  std::array<double, 3> middle;
  std::array<double, 3> scale; ///< integers per unit of length
};

/** \brief Bits of an offset of a whole reach (see \ref CellFrame::reach): as many as
 * let the sum of squares of \a points offsets, each up to twice as long, fit into 63
 * bits. */
inline int
offsetBits(std::size_t points)
{
  int bits = 30;
  while (bits > 1 && std::ldexp(static_cast<double>(points), 2 * bits + 2) >= 0x1p63)
    --bits;
  return bits;
}

/** \brief Sums over the members of a cell, of integer offsets from its middle. */
struct CellSums {
  std::int64_t count = 0;
  std::array<std::int64_t, 3> first{};  ///< x y z
  std::array<std::int64_t, 6> second{}; ///< xx xy xz yy yz zz

  CellSums&
  operator+=(const CellSums& other)
  {
    count += other.count;
    for (std::size_t a = 0; a < 3; ++a)
      first[a] += other.first[a];
    for (std::size_t a = 0; a < 6; ++a)
      second[a] += other.second[a];
    return *this;
  }

  friend bool
  operator==(const CellSums& a, const CellSums& b)
  {
    return a.count == b.count && a.first == b.first && a.second == b.second;
  }
};

/** \brief The plane of a cell's members; normal 0: none. */
struct CellPlane {
  std::array<double, 3> point{}, normal{};
};

/** \brief Sum of the field's integers over the members of a cell that have one. */
struct FieldSum {
  std::int64_t count = 0, sum = 0;
};

/** \brief The value of the field at points that have none. */
constexpr std::int32_t no_value = INT32_MIN;

/** \brief All work per point. Every engine gives the same bits: sums are of integers,
 * and decisions are computed in double in the order stated. */
class PointPasses {
public:
  virtual ~PointPasses() = default;

  /** \brief Marks and ranks the bricks, then the cells, that hold points. */
  virtual void
  fill(CellDirectory& directory, const CellFrame& frame) = 0;

  /** \brief Fills \a directory, too, and finds for every point its home cell, to which
   * it is assigned at first, and its nearest face within \a border widths; 0: points do
   * not move. */
  virtual void
  findHomes(CellDirectory& directory, const CellFrame& frame, double border) = 0;

  /** \brief Sets origin and unit of \ref sums for every slot. */
  virtual void
  setOrigins(const std::vector<CellOrigin>& origins) = 0;

  /** \brief Sets where points can move to.
   * \param[in] neighbors slots beyond the faces of every slot */
  virtual void
  setNeighbors(const Indices& neighbors) = 0;

  /** \brief How many points of a home are how far from which face:
   * (slot * faces + face) * steps + step. */
  virtual std::vector<std::uint32_t>
  borderCounts() = 0;

  /** \brief The sums over the members of every slot; valid until the next call. */
  virtual const std::vector<CellSums>&
  sums() = 0;

  virtual std::vector<FieldSum>
  fieldSums() = 0;

  /** \brief Assigns points less than shifts[slot * faces + face] steps from a face to
   * the cell beyond it, all others to their home. */
  virtual void
  moveBySteps(const std::vector<std::uint8_t>& shifts) = 0;

  /** \brief Assigns points to the nearer plane, if both cells have one: the distance is
   * |((x - px) nx + (y - py) ny) + (z - pz) nz|. */
  virtual void
  moveToPlanes(const std::vector<CellPlane>& planes) = 0;

  /** \brief Moves points across if their value is below the mean here and above the
   * mean there; NaN: a cell without a mean. */
  virtual void
  moveByField(const std::vector<double>& means) = 0;

  /** \brief Slot of every point, \ref CellDirectory::none for those that have none. */
  virtual Indices
  assigned() = 0;
};

} // namespace clustering
} // namespace linelet
