// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include <linelet/io/cloud.h>
#include <linelet/io/vector_file.h>
#include <linelet/powerline/power_line_network.h>
#include <linelet/support/progress_monitor.h>
#include <linelet/support/visibility.h>

namespace linelet {
namespace LINELET_PUBLIC powerline {

/** \brief What the outputs say beside the network itself. */
struct OutputOptions {
  std::string source;   ///< name of the input, for headings; may be empty
  double clearance = 5; ///< a clearance below this is a hazard, meters
};

/** \brief Whether a clearance of \a wire, to the ground or to vegetation, is known and
 * below \a limit. */
bool
belowClearance(const Wire& wire, double limit);

/** \brief Gives \a cloud what was found: class 14 and 15 in `classification`, and the
 * columns `wire_id` and `span_id` (0: none) and `wire_distance` (meters, NaN: none).
 * Every other class and attribute stays as it is.
 * \throws std::invalid_argument unless the network belongs to the cloud */
void
classify(io::Cloud& cloud, const PowerLineNetwork& network);

/** \brief The network as layers in world coordinates: `wires` (lines) and `pylons`
 * (points at the foot), each with its attributes; also without a feature. In a drawing
 * every wire is a layer `wires_circuit_1_span_2_wire_3`, with its main attributes as a
 * text on the layer `labels`. Coordinates are in the units of \a cloud, lengths in
 * meters. */
std::vector<io::VectorLayer>
powerLineLayers(const io::Cloud& cloud,
                const PowerLineNetwork& network,
                const OutputOptions& options);

/** \brief The network as JSON text: totals, circuits, spans, wires, pylons; keys in
 * snake_case, null for what is unknown, world coordinates in the units of \a cloud,
 * lengths in meters. */
std::string
powerLineSummary(const io::Cloud& cloud,
                 const PowerLineNetwork& network,
                 const OutputOptions& options);

/** \brief The network as one HTML page that needs nothing else: totals, plan, hazards,
 * and for every span its profile and its wires. The same input gives the same text. */
std::string
powerLineReport(const io::Cloud& cloud,
                const PowerLineNetwork& network,
                const OutputOptions& options);

/** \brief Makes \a folder if need be and makes sure that files can be written there, so
 * that this fails before long work.
 * \throws io::FileError */
void
makeOutputFolder(const std::string& folder);

/** \brief Writes `classified.las`, `wires.geojson`, `wires.gpkg`, `wires.dxf`,
 * `summary.json` and `report.html` into \a folder, which is made if need be. An empty
 * network gives the same files, valid and without wires.
 * \param[in] folder where to; older files of these names are replaced
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

} // namespace powerline
} // namespace linelet
