// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <linelet/support/points.h>
#include <linelet/tensor/weighting.h>

namespace linelet {

/** \brief The median of \ref centroid, iterated from \a start.
 * \param[in] points at least one
 * \param[in] weighting of the distance from the median, or null for none */
Point
geometricMedian(const Points& points,
                const Point& start,
                double inverse_radius,
                const Weighting* weighting);

} // namespace linelet
