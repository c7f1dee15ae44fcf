// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <linelet/support/points.h>

#include "powerline/spans/wire_with_ends.h"
#include "powerline/supports/tower.h"

namespace linelet::powerline {

/** \brief Whether a point is part of the body or the crossarms of \a tower. */
bool
belongsTo(const Tower& tower, const std::vector<WireWithEnds>& wires, const Point& p);

/** \brief Finds body, axis and top of \a tower among the points \a near (candidates
 * that no wire owns). Sets seen, pole, top, half_width, flare and the center of arm. */
void
findStructure(Tower& tower, const Points& points, const Indices& near);

} // namespace linelet::powerline
