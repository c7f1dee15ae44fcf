// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <limits>

#include "curves/ridges/model_curve.h"

namespace linelet {

/** \brief Joins curves that are one curve, seen on both sides of a hidden stretch.
 *
 * Two ends are joined if one parabola fits both curves within their noise, over as much
 * of each as the gap is wide: position, direction and curvature hardly ever agree by
 * chance. The gap is at most the mean length of the two curves, and \a widest spacings
 * of the longer one's points. The narrowest gaps come first; joined curves then reach
 * farther. Edges of a hidden stretch explain no points.
 * \param[in] curves of known points and noise
 * \param[in] widest gap, in mean spacings of the points along the curve
 * \param[in] cutoff widest gap, in the unit of the points */
ModelCurves
joinHiddenStretches(ModelCurves curves,
                    double widest,
                    double cutoff = std::numeric_limits<double>::infinity());

} // namespace linelet
