// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <linelet/curves/em_fit.h>
#include <linelet/search/uniform_grid.h>

namespace linelet {

/** \brief Whether most of some neighbourhoods of 2 or 4 times \a size are linear.
 * \param[in] grid of \a points */
bool
looksLinear(const Points& points, const UniformGrid& grid, double size);

/** \brief Whether \a start leads to the fit \a best, or to one like it: as many curves
 * of the same length and ends, nowhere farther from it than \a tolerance. */
bool
leadsTo(const EmFit& best, const ModelCurves& start, double tolerance);

} // namespace linelet
