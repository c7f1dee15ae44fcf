// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include <linelet/io/cloud.h>
#include <linelet/powerline/power_line_network.h>
#include <linelet/powerline_output/output_options.h>
#include <linelet/support/visibility.h>

namespace linelet {
namespace LINELET_PUBLIC powerline {

/** \brief The network as JSON text: totals, circuits, spans, wires, pylons; keys in
 * snake_case, null for what is unknown, world coordinates in the units of \a cloud,
 * lengths in meters. */
std::string
powerLineSummary(const io::Cloud& cloud,
                 const PowerLineNetwork& network,
                 const OutputOptions& options);

/** \brief If the summary in \a folder is of an input other than \a cloud named \a
 * source: the name of that input, or "an unknown input". Otherwise empty. */
std::string
otherResultsIn(const std::string& folder,
               const io::Cloud& cloud,
               const std::string& source);

/** \brief The same for an input given by its extent. */
std::string
otherResultsIn(const std::string& folder,
               const InputExtent& input,
               const std::string& source);

} // namespace powerline
} // namespace linelet
