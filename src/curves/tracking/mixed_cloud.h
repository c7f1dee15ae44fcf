// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <linelet/support/points.h>

namespace linelet {

/** \brief Share of \a points, estimated from a sample, around which the cloud is linear
 * at some scale: large in a cloud of curves, however noisy, and small in a scene with
 * ground, roofs and crowns.
 * \param[in] unit D */
double
linearShare(const Points& points, double unit, unsigned threads);

} // namespace linelet
