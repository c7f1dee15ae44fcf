// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>

#include <linelet/support/points.h>

namespace linelet {

/** \brief A piece of a larger cloud, together with the points around it: the points
 * \a begin to \a end of those that a function is given are the piece, the others are
 * there as neighbors, nearer than a margin that the function states.
 *
 * Results are those of the whole cloud to the bit where the points keep its order and
 * its coordinates (the same Cloud::shift). */
struct CloudPiece {
  std::size_t begin = 0, end = 0;
  Point low, high; ///< box of the whole cloud
};

} // namespace linelet
