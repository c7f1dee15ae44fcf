// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "powerline/pieces/span_model.h"
#include "powerline/terrain/underside.h"

namespace linelet::powerline {

/** \brief Whether the data ends within a few meters beyond one end of \a model. */
bool
leavesData(const SpanModel& model, int side, const Underside& underside);

} // namespace linelet::powerline
