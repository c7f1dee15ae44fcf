// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <linelet/powerline/power_line_settings.h>

#include "powerline/pieces/growth.h"
#include "powerline/spans/wire_with_ends.h"
#include "powerline/terrain/underside.h"

namespace linelet::powerline {

/** \brief Searches for the span between wires whose ends face each other with nothing
 * in between: a line does not end at its supports. Both ends are known, and its tension
 * is about that of the neighboring spans, which leaves few hypotheses, so each needs
 * less evidence. Ends must be matched before, and again afterward.
 * \return whether there were any */
bool
addSpansBetween(std::vector<WireWithEnds>& wires,
                Growth& growth,
                const Underside& underside,
                const PowerLineSettings& settings);

/** \brief Searches for the next span of wires that end beside others that continue: it
 * runs beside theirs as their ends do. Otherwise like \ref addSpansBetween. */
bool
addSpansBeside(std::vector<WireWithEnds>& wires,
               Growth& growth,
               const Underside& underside,
               const PowerLineSettings& settings);

} // namespace linelet::powerline
