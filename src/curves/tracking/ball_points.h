// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <linelet/support/points.h>

namespace linelet {

/** \brief Points in a ball, in the order in which they were tested. */
struct BallPoints {
  /// Doubles of a vector, at most: as many entries beyond the last may be written.
  static constexpr std::size_t padding = 8;

  std::size_t count = 0;
  std::vector<std::uint64_t> index;
  std::array<std::vector<double>, 3> offset; ///< from the middle, by axis
  std::vector<double> squared; ///< squares of their distances from the middle
};

/** \brief Appends those of the points \a begin to \a end that lie within \a radius of
 * \a middle to \a found, by the instruction set of the machine; the bits are the same
 * on all. */
void
appendPointsInBall(const Point& middle,
                   double radius,
                   const Points& points,
                   std::size_t begin,
                   std::size_t end,
                   BallPoints& found);

/** \brief How many of \a points lie in a cylinder through the middle of their ball.
 * \param[in] direction of its axis, a unit vector
 * \param[in] squared_half its points lie as near to the middle as this allows */
std::size_t
countInCylinder(const BallPoints& points,
                const Point& direction,
                double squared_half,
                double squared_radius);

} // namespace linelet
