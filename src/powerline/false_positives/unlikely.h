// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <linelet/powerline/power_line_settings.h>

#include "powerline/pieces/growth.h"
#include "powerline/spans/wire_with_ends.h"
#include "powerline/terrain/underside.h"

namespace linelet::powerline {

/** \brief Drops what only looks like a wire. A wire has the evidence and the
 * scatter of its line; lines are long, leave the data or lead to a house, and hang.
 * What is dropped frees its points. Ends must be matched before.
 * \param[in] terrain whether the cloud shows terrain: lines then hang clear of it */
void
dropUnlikely(std::vector<WireWithEnds>& wires,
             Growth& growth,
             const Underside& underside,
             bool terrain,
             const PowerLineSettings& settings);

} // namespace linelet::powerline
