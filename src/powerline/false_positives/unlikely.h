// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <linelet/powerline/power_line_settings.h>

#include "powerline/pieces/growth.h"
#include "powerline/spans/wire_with_ends.h"
#include "powerline/terrain/underside.h"

namespace linelet::powerline {

/** \brief Drops what only looks like a wire. A wire ends at a support or at the border
 * of the data; short families of wires inside the data with neither, or without sag,
 * are chords of booms and crossarms, and straight steep loose pieces are ropes. Their
 * points become free. Ends must already be matched.
 * \param[in] terrain whether the cloud shows terrain: lines then hang clear of it */
void
dropUnlikely(std::vector<WireWithEnds>& wires,
             Growth& growth,
             const Underside& underside,
             bool terrain,
             const PowerLineSettings& settings);

} // namespace linelet::powerline
