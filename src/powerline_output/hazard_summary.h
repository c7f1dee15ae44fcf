// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <nlohmann/json.hpp>

#include <linelet/io/cloud.h>
#include <linelet/powerline/hazards.h>

namespace linelet::powerline {

/** \brief The hazards of every state: limits, counts by kind and severity, and each
 * hazard with its ids, distances and places. */
nlohmann::ordered_json
hazardSummary(const io::Cloud& cloud, const std::vector<Hazards>& states);

} // namespace linelet::powerline
