// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <limits>

#include "curves/ridges/model_curve.h"

namespace linelet {

/** \brief Joins curves that are one, seen on both sides of a stretch that is hidden.
 *
 * Two ends are joined where one parabola runs through both curves within their noise,
 * from as far before the gap as it is wide to as far behind it: position, direction and
 * curvature agree by chance hardly ever. The gap is no wider than the two curves are
 * long in the mean, nor than \a widest spacings of the longer one's points. The
 * narrowest come first; what is joined then reaches farther. Edges of a hidden stretch
 * explain no points.
 * \param[in] curves of known points and noise
 * \param[in] widest gap, in mean distances of the points along the curves
 * \param[in] cutoff widest gap, in the unit of the points */
ModelCurves
joinHiddenStretches(ModelCurves curves,
                    double widest,
                    double cutoff = std::numeric_limits<double>::infinity());

} // namespace linelet
