// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "model_curve.h"

namespace linelet {

/** \brief What the points of a cloud look like around its curves. */
struct SegmentSettings {
  double noise = 0;        ///< standard deviation per coordinate across a curve
  double density = 0;      ///< points per length of a curve
  double background = 0;   ///< points per volume (area) that lie on no curve
  int dimensions = 3;      ///< 2 if the points lie in a plane
  double least_length = 0; ///< of a segment
};

/** \brief Straight segments that explain \a points, the most telling one first.
 *
 * A segment adds to the intensity of a Poisson process, lambda N(d; noise) per volume
 * at distance d from it, whose logarithmic likelihood grows by the sum over the points
 * of log(1 + lambda N / intensity so far) less lambda times its length. For the line
 * through two points that no segment explains, the best interval follows from one pass
 * along it; the best of many such pairs is refined by weighted least squares. Segments
 * that pass through each other or meet do not disturb each other, whatever the angle:
 * unlike ridges, which have no direction there.
 * \return those whose gain exceeds what the Bayesian information criterion asks for */
ModelCurves
straightSegments(const Points& points, const SegmentSettings& settings);

} // namespace linelet
