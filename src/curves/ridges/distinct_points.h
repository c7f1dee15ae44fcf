// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <linelet/support/points.h>

namespace linelet {

/** \brief The points of \a indices, in their order. */
Points
pointsAt(const Points& points, const Indices& indices);

/** \brief The finite ones of \a points, each position once, in input order: a duplicate
 * adds no information, but would count twice and shrink the spacing.
 * \return indices, ascending */
Indices
distinct(const Points& points);

/** \brief At most 100 of \a points in every cubic cell of side \a size (the unit of the
 * points), spread over the input order. Otherwise every point of a dense cluster would
 * have the whole cluster as neighbors.
 * \return indices, ascending */
Indices
thinned(const Points& points, double size);

/** \brief For each cell of side \a size, the point nearest to the mean of its points,
 * in input order. */
Points
onePerCell(const Points& points, double size);

} // namespace linelet
