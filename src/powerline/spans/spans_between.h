// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <linelet/powerline/power_line_settings.h>

#include "powerline/pieces/growth.h"
#include "powerline/spans/wire_with_ends.h"
#include "powerline/terrain/underside.h"

namespace linelet::powerline {

/** \brief Looks for the span between wires that end facing each other with nothing in
 * between: a line does not end at its supports. Both ends are known and its tension is
 * about that of the spans beside it, which leaves few places to look at, and less is
 * asked of each. Ends must have been matched, and have to be again.
 * \return whether there were any */
bool
addSpansBetween(std::vector<WireWithEnds>& wires,
                Growth& growth,
                const Underside& underside,
                const PowerLineSettings& settings);

/** \brief Looks for the next span of wires that end beside others which go on: it hangs
 * beside theirs as their ends do. The rest as for \ref addSpansBetween. */
bool
addSpansBeside(std::vector<WireWithEnds>& wires,
               Growth& growth,
               const Underside& underside,
               const PowerLineSettings& settings);

} // namespace linelet::powerline
