// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <linelet/curves/curve_network.h>
#include <linelet/search/uniform_grid.h>

#include "line_lets.h"

namespace linelet {

/** \brief Cuts open ends back to where a point is within \a distance. Vertices at which
 * line-lets are joined stay. */
void
pruneOpenEnds(LineLets& lets, const UniformGrid& grid, double distance);

/** \brief Joins line-lets at what they share: polylines between free ends and
 * junctions, closed curves. Polylines with a free end that are shorter than \a
 * stump_length are dropped. */
CurveNetwork
join(const LineLets& lets, double stump_length);

} // namespace linelet
