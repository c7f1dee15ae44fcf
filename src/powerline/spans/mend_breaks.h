// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <vector>

#include <linelet/powerline/power_line_settings.h>

#include "powerline/pieces/growth.h"
#include "powerline/spans/wire_with_ends.h"

namespace linelet::powerline {

/** \brief Whether more wires of a line run past a place without an end than the \a
 * ending that end there: then no support stands there. */
bool
isPassedBy(const std::vector<WireWithEnds>& wires,
           const Point& place,
           const Eigen::Vector2d& along,
           std::size_t ending);

/** \brief Joins partners that meet where the rest of their line runs past: no support
 * breaks them, but too few points, or a bundle of which each took another conductor.
 * Ends must have been matched, and have to be again.
 * \return whether there were any */
bool
mendBreaks(std::vector<WireWithEnds>& wires,
           Growth& growth,
           const PowerLineSettings& settings);

} // namespace linelet::powerline
