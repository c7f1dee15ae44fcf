// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>

#include <linelet/support/points.h>

namespace linelet {

/** \brief A piece of a larger cloud, together with the points around it: of the points
 * passed to a function, those from \ref begin to \ref end are the piece; the others are
 * neighbors, within a margin that the function states.
 *
 * Results are bit for bit those of the whole cloud if the points keep its order and
 * coordinates (the same Cloud::shift). */
struct CloudPiece {
  std::size_t begin = 0, end = 0;
  Point low, high; ///< box of the whole cloud
};

} // namespace linelet
