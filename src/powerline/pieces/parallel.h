// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "powerline/pieces/span_model.h"

namespace linelet::powerline {

/** \brief Mean distance of two wires where they run side by side, and the length over
 * which they do.
 */
struct Parallel {
  double distance = 0; ///< meters; meaningful only with overlap > 0
  double overlap = 0;  ///< meters
};

Parallel
compare(const SpanModel& a, const SpanModel& b);

} // namespace linelet::powerline
