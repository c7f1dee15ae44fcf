// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <linelet/powerline/ground.h>
#include <linelet/support/points.h>

#include "powerline/terrain/plan_extent.h"

namespace linelet::powerline {

/** \brief Sets every cell to the mean height of the points next to the surface, since
 * the minima of cells lie too low on slopes. \param[in] threads 0: all */
void
refineGround(Ground& ground,
             const PlanExtent& extent,
             const Points& points,
             unsigned threads);

} // namespace linelet::powerline
