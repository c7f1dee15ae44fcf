// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <linelet/search/uniform_grid.h>

#include "curves/ridges/model_curve.h"

namespace linelet {

/** \brief \a curves, with each one doubled whose points lie on two sides of it.
 *
 * This shows in the spread of their offsets across the curve: the variance in one
 * direction is at least \a least_spread times that in the other.
 * \param[in] grid of \a points
 * \param[in] reach points farther from a curve do not count
 * \return nothing if there is no such curve */
ModelCurves
doubled(const ModelCurves& curves,
        const Points& points,
        const UniformGrid& grid,
        double reach,
        double least_spread);

} // namespace linelet
