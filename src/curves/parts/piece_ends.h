// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <linelet/curves/curve_parts.h>

namespace linelet {

/** \brief What an end of a piece is joined to. */
struct PieceLink {
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  std::size_t to = none;     ///< end: 2 * piece, + 1 for its back
  std::optional<Point> seam; ///< where one turns into the other; none: at the end
  Points bridge;             ///< vertices on the way
  /// Number of vertices of the other, from that end on, that both share
  std::size_t skip = 0;
};

/** \brief By end. */
using PieceLinks = std::vector<PieceLink>;

/** \brief Finds ends of \a pieces that belong to one curve, see \ref joinParts.
 * \param[in] part_of the part of each piece */
PieceLinks
linkEnds(const std::vector<CurvePiece>& pieces,
         const std::vector<std::size_t>& part_of,
         double tolerance);

} // namespace linelet
