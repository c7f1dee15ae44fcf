// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "powerline/pieces/span_model.h"
#include "powerline/terrain/underside.h"

namespace linelet::powerline {

/** \brief Fraction of a wire with nothing close below it or to the side of that, unlike
 * on roofs and rocks. Right below, a sparse scan may show only the wire itself. */
double
openBelow(const SpanModel& m, const Underside& underside);

/** \brief Whether enough of a wire is open below for it to be one: crowns let pulses
 * through, roofs do not. */
bool
isOpenBelow(const SpanModel& m, const Underside& underside);

} // namespace linelet::powerline
