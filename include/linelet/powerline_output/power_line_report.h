// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include <linelet/io/cloud.h>
#include <linelet/powerline/power_line_network.h>
#include <linelet/powerline_output/output_options.h>
#include <linelet/support/progress_monitor.h>
#include <linelet/support/visibility.h>

namespace linelet {
namespace LINELET_PUBLIC powerline {

/** \brief The network as one self-contained HTML page: totals, plan, hazards, and the
 * profile and wires of every span. The same input gives the same text. */
std::string
powerLineReport(const io::Cloud& cloud,
                const PowerLineNetwork& network,
                const OutputOptions& options,
                const ProgressMonitor* monitor = nullptr);

} // namespace powerline
} // namespace linelet
