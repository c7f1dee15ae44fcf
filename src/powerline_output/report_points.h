// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "report_page.h"

namespace linelet::powerline::report {

/** \brief Points of the cloud beside every span, at most a few thousand each. */
std::vector<Indices>
pointsOfSpans(const Content& content);

} // namespace linelet::powerline::report
