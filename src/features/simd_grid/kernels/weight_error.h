// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <linelet/tensor/weighting.h>

namespace linelet::grid {

/** \brief Bound on the error of a weight computed in float: absolute + relative * w. */
struct WeightError {
  double absolute, relative;
};

/** \brief The error of the inner loops' weights, the rounding of x included. */
WeightError
weightError(const Weighting& weighting);

} // namespace linelet::grid
