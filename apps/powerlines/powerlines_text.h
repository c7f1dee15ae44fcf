// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <nlohmann/json.hpp>

#include <linelet/powerline/hazards.h>
#include <linelet/powerline/power_line_network.h>

namespace linelet::apps {

/** \brief Prints what was found in \a points points; \a clearance is the limit. */
void
printPowerLines(const powerline::PowerLineNetwork& network,
                const std::vector<powerline::Hazards>& hazards,
                double points,
                double clearance);

/** \brief The same for --json. */
void
summarizePowerLines(nlohmann::ordered_json& summary,
                    const powerline::PowerLineNetwork& network,
                    const std::vector<powerline::Hazards>& hazards,
                    double clearance);

} // namespace linelet::apps
