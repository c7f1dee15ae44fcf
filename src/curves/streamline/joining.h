// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <linelet/curves/curve_network.h>

#include "line_lets.h"

namespace linelet {

/** \brief Joins line-lets at shared vertices: polylines between free ends and
 * junctions, and closed curves. Polylines with a free end that are shorter than \a
 * stump_length are dropped. */
CurveNetwork
join(const LineLets& lets, double stump_length);

} // namespace linelet
