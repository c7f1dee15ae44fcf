// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <linelet/powerline/power_line_network.h>

#include "powerline/supports/tower.h"

namespace linelet::powerline {

/** \brief \a towers as supports, with ids in their order. */
std::vector<Support>
describeSupports(const std::vector<Tower>& towers, bool has_terrain);

} // namespace linelet::powerline
