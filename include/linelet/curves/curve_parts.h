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
 * what an owner has is convex. */
using PartOwner = std::function<std::size_t(const Point&)>;

/** \brief What a part owns of a curve that was found in it. */
struct CurvePiece {
  static constexpr std::size_t whole = static_cast<std::size_t>(-1);

  /** \brief Where the curve was cut, at the border of what the part owns. */
  struct Cut {
    std::size_t neighbor = whole; ///< who owns what is beyond; whole: it was not cut
    Points beyond; ///< how the curve went on there, away from the cut, without it
  };

  Curve curve; ///< evidence: the share of it; ends at a cut: EndKind::Bounds
  std::array<Cut, 2> cuts; ///< front and back
};

/** \brief The curves of a part, as far as it owns them. */
struct CurvePart {
  std::vector<CurvePiece> pieces;
  std::vector<Junction> junctions; ///< of \ref pieces
};

/** \brief Cuts the curves that were found in a part, with what is around it, to what
 * the part owns.
 * \param[in] self the part
 * \param[in] reach how far to note how curves go on */
CurvePart
ownedBy(const CurveNetwork& found,
        std::size_t self,
        const PartOwner& owner,
        double reach);

/** \brief The curves of a whole cloud, of those of its parts.
 *
 * Where two parts cut what is one curve, each knows how the other goes on: the pieces
 * are joined whose courses lie within \a tolerance of one another at the border, the
 * closest first. One that the neighbor has as far as the border only is joined to that
 * end. Noise is the root of the mean square, density the mean over the length, evidence
 * the sum. Curves and junctions are in the order of their places, however the cloud was
 * divided.
 * \param[in] tolerance distance across the curves, unit of the points */
CurveNetwork
joinParts(std::vector<CurvePart> parts, double tolerance);

} // namespace linelet
