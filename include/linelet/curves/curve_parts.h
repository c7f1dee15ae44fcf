// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

#include <linelet/curves/curve_network.h>
#include <linelet/support/points.h>
#include <linelet/support/visibility.h>

namespace LINELET_PUBLIC linelet {

/** \brief The part of a cloud that owns a place in plan. Every place has one owner, and
 * the places of an owner form a convex region. */
using PartOwner = std::function<std::size_t(const Point&)>;

/** \brief The portion of a curve found in a part that the part owns. */
struct CurvePiece {
  static constexpr std::size_t whole = static_cast<std::size_t>(-1);

  /** \brief Where the curve was cut, at the border of what the part owns. */
  struct Cut {
    /// Part that owns what lies beyond; whole: not cut
    std::size_t neighbor = whole;
    Points beyond; ///< how the curve continued, without the cut itself
  };

  Curve curve; ///< evidence: this piece's share; an end at a cut is EndKind::Bounds
  std::array<Cut, 2> cuts; ///< front and back
};

/** \brief The curves of a part, cut to what it owns. */
struct CurvePart {
  std::vector<CurvePiece> pieces;
  std::vector<Junction> junctions; ///< of \ref pieces
};

/** \brief Cuts curves found in a part and its surroundings to what the part owns.
 * \param[in] self the part
 * \param[in] reach length of CurvePiece::Cut::beyond */
CurvePart
ownedBy(const CurveNetwork& found,
        std::size_t self,
        const PartOwner& owner,
        double reach);

/** \brief The curves of a whole cloud, joined from those of its parts.
 *
 * Where a curve was cut, both parts know how it continues: pieces whose courses lie
 * within \a tolerance of each other at the border are joined, the closest first. If the
 * neighbor has the curve only up to the border, the piece is joined to that end. Noise
 * becomes the root mean square, density the mean over the length, evidence the sum.
 * Curves and junctions are sorted by place, however the cloud was divided.
 * \param[in] tolerance distance across the curves, unit of the points */
CurveNetwork
joinParts(std::vector<CurvePart> parts, double tolerance);

} // namespace linelet
