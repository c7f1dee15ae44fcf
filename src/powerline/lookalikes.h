// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause


#pragma once

#include <vector>

#include <linelet/powerline/ground.h>

#include "powerline/joints.h"

namespace linelet::powerline {

/** \brief Whether \a piece is too straight for a wire: its points rule out even the sag
 * of a taut one. Jibs, ridges, railings and pipes are. Short pieces tell nothing. */
bool
isStraight(const Piece& piece, const Points& points);

/** \brief Which wires are the top of a fence: below them, down to the ground, something
 * stands nearly everywhere, and not so beside. One entry a wire. */
std::vector<char>
findFences(const std::vector<Hanging>& wires, const Points& points, const Ground& ground);

/** \brief Whether \a piece is the railing or edge of a roof: a plane begins beside it,
 * at about its height, all along. */
bool
isLedge(const Growth& growth, const Piece& piece);

/** \brief Whether a wire is a crossarm: short, and longer wires end at it from the
 * side. */
bool
isCrossarm(const std::vector<Hanging>& wires, std::size_t candidate);

} // namespace linelet::powerline
