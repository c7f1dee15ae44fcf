// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "curves/ridges/model_curve.h"

namespace linelet {

/** \brief Lines side by side along one curve. */
struct ParallelLines {
  ModelCurves curves; ///< in the order of their points, most first
  double width = 0;   ///< scale at which they were resolved
  /// Of each of them from the single curve, in its frames.
  std::vector<Eigen::Vector2d> offsets;
};

/** \brief Lines of constant offsets from \a curve along which \a points gather: the
 * modes of its cross-section, at a few scales below \a noise.
 * \param[in] points around the curve
 * \param[in] noise their standard deviation about it, per coordinate
 * \param[in] least_width finest scale
 * \return one set of lines for each scale that shows several */
std::vector<ParallelLines>
linesAlong(const ModelCurve& curve,
           const Points& points,
           double noise,
           double least_width);

} // namespace linelet
