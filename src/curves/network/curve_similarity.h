// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <linelet/search/uniform_grid.h>

#include "curves/ridges/model_curve.h"

namespace linelet {

/** \brief Whether most of some neighborhoods of 2 or 4 times \a size are linear.
 * \param[in] grid of \a points */
bool
looksLinear(const Points& points, const UniformGrid& grid, double size);

/** \brief Whether each curve of \a some runs beside one of \a others over its whole
 * length, within \a tolerance, and vice versa: a fit that starts from either has the
 * same topology. */
bool
ofOneCourse(const ModelCurves& some, const ModelCurves& others, double tolerance);

} // namespace linelet
