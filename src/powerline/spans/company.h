// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <linelet/powerline/power_line_settings.h>

#include "powerline/pieces/growth.h"
#include "powerline/spans/wire_with_ends.h"

namespace linelet::powerline {

/** \brief Joins the parts of wires whose middle is hidden, where a wire beside both
 * tells that one hangs on as the other. */
void
joinBesideCompany(std::vector<WireWithEnds>& wires,
                  Growth& growth,
                  const PowerLineSettings& settings);

} // namespace linelet::powerline
