// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <linelet/powerline/power_line_network.h>

#include "powerline/pieces/span_model.h"

namespace linelet::powerline {

/** \brief Fits a catenary, in a plane that wind may have swung out, to points by robust
 * least squares.
 * \param[in] start a parabola near the answer; its begin and end bound the curve
 * \param[in] members indices in \a points
 * \param[in] fixed attachment points that the curve must pass (0 to 2)
 * \param[in] cut members farther from the curve, in meters, have no weight
 * \return the curve, from the begin to the end of \a start (or to the attachment
 * points) */
Catenary
fitCatenary(const SpanModel& start,
            const Points& points,
            const Indices& members,
            const Points& fixed = {},
            double cut = usual_cut);

} // namespace linelet::powerline
