// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <linelet/support/points.h>

#include "powerline/spans/wire_with_ends.h"
#include "powerline/supports/tower.h"

namespace linelet::powerline {

/** \brief Fits the crossarm of \a tower to its attachment points. */
void
fitCrossarm(Tower& tower, const std::vector<WireWithEnds>& wires);

/** \brief Moves the crossarm of \a tower along the line to where its wires, all
 * together, bend most clearly: in a dip of the terrain, each one alone shows little. */
void
moveToKink(Tower& tower, const std::vector<WireWithEnds>& wires, const Points& points);

} // namespace linelet::powerline
