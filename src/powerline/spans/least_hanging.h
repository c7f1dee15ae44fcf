// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>

#include "powerline/pieces/span_model.h"

namespace linelet::powerline {

/** \brief Smallest possible distance in plan between the attachment points of \a model,
 * meters: most of its visible stretch must lie between supports. */
inline double
leastHanging(const SpanModel& model)
{
  constexpr double least = 3, part = 0.5; // meters; of the stretch with points
  return std::max(least, part * model.length());
}

} // namespace linelet::powerline
