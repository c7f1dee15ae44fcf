// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "powerline/pieces/growth.h"

namespace linelet::powerline {

/** \brief Drops the pieces that run straight through wires of a rack, and frees their
 * points: where wires sag about as much as they are apart, a straight line leads from
 * the middle of one to the ends of the next. */
void
dropChords(Growth& growth, std::vector<Piece>& pieces);

} // namespace linelet::powerline
