// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include <linelet/io/cloud.h>
#include <linelet/powerline/power_line_network.h>
#include <linelet/powerline_output/below_clearance.h>
#include <linelet/powerline_output/class_scheme.h>
#include <linelet/powerline_output/hazard_layers.h>
#include <linelet/powerline_output/output_options.h>
#include <linelet/powerline_output/power_line_layers.h>
#include <linelet/powerline_output/power_line_report.h>
#include <linelet/powerline_output/power_line_summary.h>
#include <linelet/powerline_output/result_files.h>
#include <linelet/support/progress_monitor.h>
#include <linelet/support/visibility.h>

namespace linelet {
namespace LINELET_PUBLIC powerline {

/** \brief Creates \a folder if it does not exist and checks that files can be written
 * there, so that failures come before long work.
 * \throws io::FileError */
void
makeOutputFolder(const std::string& folder, bool compress = false);

/** \brief Writes `classified.las` (or `.laz`), wires and hazards as .geojson, .gpkg and
 * .dxf, `clearances.csv`, `crossings.csv`, `fall_in.csv`, `summary.json` and
 * `report.html` into \a folder, which is created if it does not exist. An empty network
 * gives the same files, valid and without wires.
 * \param[in] folder where to write; existing files of these names are replaced
 * \param[in] cloud what the network was extracted from; move it in to save memory
 * \param[out] warnings one sentence for everything that a format cannot hold
 * \return the paths of the files, in the order above
 * \throws io::FileError */
std::vector<std::string>
writePowerLineFiles(const std::string& folder,
                    io::Cloud cloud,
                    const PowerLineNetwork& network,
                    const OutputOptions& options = {},
                    std::vector<std::string>* warnings = nullptr,
                    ProgressMonitor* monitor = nullptr);

/** \brief Writes the same files except the classified cloud; \a cloud may hold just the
 * points that the pictures show, if \ref OutputOptions::input is set. */
std::vector<std::string>
writeNetworkFiles(const std::string& folder,
                  const io::Cloud& cloud,
                  const PowerLineNetwork& network,
                  const OutputOptions& options = {},
                  std::vector<std::string>* warnings = nullptr,
                  ProgressMonitor* monitor = nullptr);

/** \brief Warns of \a unconfirmed points, see \ref classify, and of lines that the
 * network does not explain. */
void
warnOfDoubts(const PowerLineNetwork& network,
             std::size_t unconfirmed,
             const ClassScheme& classes,
             std::vector<std::string>* warnings);

} // namespace powerline
} // namespace linelet
