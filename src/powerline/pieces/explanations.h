// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <linelet/powerline/power_line_settings.h>

#include "powerline/pieces/growth.h"
#include "powerline/pieces/piece.h"

namespace linelet::powerline {

/** \brief The pieces of \a first, except where those of \a second explain the same
 * candidates better.
 *
 * Pieces of the two that share most of their points compete if one of them is wider
 * than the tube that wires grow in. The side wins whose wires make the points of both
 * likelier: a Poisson process of wires with normal residuals over the density of
 * everything else around, less the cost of each wire's parameters (Bayesian information
 * criterion). So one wire in a wide beam wins over the two that tubes make of it, and
 * the wires of a rack over one in their middle, even if some of them were not found:
 * what they leave counts as that one's. Narrow pieces stay, as chance would decide
 * between them, and so would the border of a part.
 *
 * \a growth is released, and the points of the result are claimed in it. */
std::vector<Piece>
likelierPieces(Growth& growth,
               std::vector<Piece> first,
               std::vector<Piece> second,
               const PowerLineSettings& settings);

} // namespace linelet::powerline
