// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <vector>

#include "model_curve.h"
#include "ridge_field.h"

namespace linelet {

/** \brief Curves traced along ridges, and the places where their ends ran into other
 * curves. */
struct Traces {
  ModelCurves curves; ///< nodes about 0.4 b apart
  Points meetings;    ///< places where a trace was attached to another curve
};

/** \brief Bounds on the work of \ref traceRidges; 0: bounded only by the points. */
struct TraceLimits {
  std::size_t seeds = 0;
  std::size_t steps = 0;
};

/** \brief Traces the ridges of \a field from seeds that no earlier trace explains.
 *
 * A step of 0.4 b along the major direction of the local covariance, blended with the
 * last direction where the surroundings are not linear, is followed by three correctors
 * x += (I - d d^T)(m - x) toward the local mean m. A trace ends where the support falls
 * below 0.45 of its running value and does not recover within 3b, or where it comes
 * within 0.8 b of another trace (attached) or of its own start (closed). Work is
 * bounded by the length that the points can support. */
Traces
traceRidges(const RidgeField& field, const TraceLimits& limits = {});

} // namespace linelet
