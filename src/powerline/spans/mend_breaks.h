// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <vector>

#include <linelet/powerline/power_line_settings.h>

#include "powerline/pieces/growth.h"
#include "powerline/spans/wire_with_ends.h"

namespace linelet::powerline {

/** \brief Whether more wires of a line pass a place than the \a ending ones that end
 * there, so that there is no support. */
bool
isPassedBy(const std::vector<WireWithEnds>& wires,
           const Point& place,
           const Eigen::Vector2d& along,
           std::size_t ending);

/** \brief Joins partners that meet where the rest of their line passes: they are broken
 * not by a support, but by too few points, or because they follow different conductors
 * of a bundle. Ends must be matched before, and again afterward.
 * \return whether there were any */
bool
mendBreaks(std::vector<WireWithEnds>& wires,
           Growth& growth,
           const PowerLineSettings& settings);

} // namespace linelet::powerline
