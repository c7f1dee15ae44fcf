// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>

#include "cloud_frame.h"
#include "em_model.h"

namespace linelet {

/** \brief Bayesian information criterion of \a fit: -2 log L + k log n, lower is
 * better.
 *
 * k is 2 for every curve (its share and its existence), 1 for each of its ends (a
 * closed curve has none), plus the effective degrees of freedom of its shape, and 1 for
 * outliers if there are any. The cost of varied noise is added (\ref
 * EmFit::width_cost). \a points: n */
double
scoreOf(const EmFit& fit, std::size_t points);

/** \brief The criterion for no curve at all: every point uniform in the frame. */
double
scoreOfNothing(const CloudFrame& frame, std::size_t points);

} // namespace linelet
