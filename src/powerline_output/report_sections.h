// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <linelet/support/progress_monitor.h>

#include "report_section.h"

namespace linelet::powerline::report {

/** \brief All sections of the page, in order. A new section needs a function, a
 * template in page/ and a line here. */
std::vector<Section>
sectionsOf(const Content& content, const ProgressMonitor* monitor);

} // namespace linelet::powerline::report
