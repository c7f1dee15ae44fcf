// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <linelet/support/points.h>

namespace linelet {

/** \brief A stretch of a tube about a parabola. */
struct Tube {
  Point at;        ///< where it begins
  Point direction; ///< unit tangent there
  Point curvature; ///< second derivative by length
  double length;   ///< along the tangent
  double squared_radius;
};

/** \brief Points in a tube, in the order in which they were tested. */
struct TubePoints {
  /// Doubles of a vector, at most: as many entries beyond the last may be written.
  static constexpr std::size_t padding = 8;

  std::size_t count = 0;
  std::vector<std::uint64_t> index;
  std::vector<double> place;   ///< along the tangent, > 0
  std::vector<double> squared; ///< squares of their distances from the parabola
};

/** \brief Appends those of the points \a begin to \a end that lie in \a tube to
 * \a found, by the instruction set of the machine; the bits are the same on all. */
void
appendPointsInTube(const Tube& tube,
                   const Points& points,
                   std::size_t begin,
                   std::size_t end,
                   TubePoints& found);

} // namespace linelet
