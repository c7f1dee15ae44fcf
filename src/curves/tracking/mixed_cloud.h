// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <linelet/support/points.h>

namespace linelet {

/** \brief Share of \a points, by a sample of them, around which the cloud is linear on
 * some scale: most of a cloud of curves, however noisy, and few of a scene with ground,
 * roofs and crowns.
 * \param[in] unit D */
double
linearShare(const Points& points, double unit, unsigned threads);

} // namespace linelet
