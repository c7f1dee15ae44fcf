// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <linelet/powerline/power_line_settings.h>

#include "powerline/pieces/growth.h"

namespace linelet::powerline {

/** \brief Widens \a piece to the points that the beam scatters sideways, if they fill
 * the tube of a wire and are not two wires. */
void
widenToBeam(const Growth& growth, Piece& piece, const PowerLineSettings& settings);

} // namespace linelet::powerline
