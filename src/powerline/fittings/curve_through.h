// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <linelet/support/points.h>

namespace linelet::powerline {

/** \brief The center line of \a points along a rough course through them: local
 * least-squares lines, window by window.
 * \param[in] course vertices, at least one
 * \param[in] window standard deviation of the weights along the course, and spacing of
 * the vertices */
Points
curveThrough(const Points& course, const Points& points, double window);

/** \brief Distance of \a p from a polyline. */
double
distanceTo(const Points& course, const Point& p);

} // namespace linelet::powerline
