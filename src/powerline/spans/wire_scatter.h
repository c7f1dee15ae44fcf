// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <linelet/support/points.h>

#include "powerline/pieces/scan_scatter.h"
#include "powerline/spans/wire_with_ends.h"

namespace linelet::powerline {

/** \brief How the single ones among \a wires scatter. */
ScanScatter
scatterOf(const std::vector<WireWithEnds>& wires, const Points& points);

} // namespace linelet::powerline
