// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <nlohmann/json.hpp>

#include "report_section.h"

namespace linelet::powerline::report {

/** \brief Table of the wires of a span (see report_table.h). */
nlohmann::ordered_json
wireTable(const Content& content, const Span& span);

/** \brief Table of all spans. */
nlohmann::ordered_json
spanTable(const Content& content);

/** \brief Everything below the clearance limit, the closest first. */
Section
clearancesSection(const Content& content);

} // namespace linelet::powerline::report
