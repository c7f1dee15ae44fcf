// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <linelet/support/points.h>

namespace linelet {

/** \brief The finite points of \a points, each place once, in the order of the input: a
 * copy says nothing new, yet would count twice and shrink the spacing. */
Points
distinct(const Points& points);

/** \brief At most 100 of \a points in every cubic cell of side \a size (the unit of the
 * points), spread over the order of the input. Points crowded far beyond the spacing of
 * the others would otherwise each look at all of the crowd. */
Points
thinned(const Points& points, double size);

} // namespace linelet
