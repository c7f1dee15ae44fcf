// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <linelet/powerline/power_line_settings.h>

#include "powerline/pieces/growth.h"

namespace linelet::powerline {

/** \brief Joins pieces that are parts of one wire: a single parabola explains both as
 * well as two do, and the gap between them is no longer than the settings allow. Joined
 * wires are fitted and extended again. */
void
mergePieces(Growth& growth,
            std::vector<Piece>& pieces,
            const PowerLineSettings& settings);

} // namespace linelet::powerline
