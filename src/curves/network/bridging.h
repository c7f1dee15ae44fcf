// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>

#include "curves/ridges/model_curve.h"

namespace linelet {

/** \brief Joins free ends of curves across gaps where both sides agree.
 *
 * Two ends (of one curve or of two) are joined if the direction of each is within 35
 * degrees of the gap and the gap is at most 15 % of the joined length, gap included;
 * gaps of up to \a near are joined within \a near_angle, whatever the length. Narrow
 * gaps with good agreement come first; joined curves then count with their new length.
 * A wide gap is bridged by a cubic that keeps both directions, or straight where one of
 * them is off by more than 60 degrees.
 * \param[in] widest no wider gap is bridged; 0: no limit
 * \param[in] reach directions are taken over this length */
ModelCurves
bridgeGaps(const ModelCurves& curves,
           double near,
           double widest,
           double reach,
           double near_angle = M_PI / 3);

} // namespace linelet
