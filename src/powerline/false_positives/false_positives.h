// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <linelet/powerline/ground.h>

#include "powerline/pieces/growth.h"
#include "powerline/spans/wire_with_ends.h"

namespace linelet::powerline {

/** \brief Drops long, thin objects that are not wires: those too straight even for a
 * taut one (jibs, ridges, pipes), fences, edges and railings of roofs, crossarms, guys.
 * Their points become free. \a points is the whole cloud, of which nothing below \a
 * min_height above the ground is a candidate. */
void
dropFalsePositives(std::vector<WireWithEnds>& wires,
                   Growth& growth,
                   const Points& points,
                   const Ground& ground,
                   double min_height);

} // namespace linelet::powerline
