// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <linelet/io/cloud.h>
#include <linelet/io/vector_file.h>
#include <linelet/powerline/power_line_network.h>
#include <linelet/powerline_output/output_options.h>
#include <linelet/support/visibility.h>

namespace linelet {
namespace LINELET_PUBLIC powerline {

/** \brief The network as layers in world coordinates: `wires` (lines), `pylons` (points
 * at the foot) and `unexplained` (lines), each with its attributes; empty layers are
 * included. In a DXF drawing every wire is a layer `wires_circuit_1_span_2_wire_3`,
 * with its main attributes as a text on the layer `labels`. Coordinates are in the
 * units of \a cloud, lengths in meters. */
std::vector<io::VectorLayer>
powerLineLayers(const io::Cloud& cloud,
                const PowerLineNetwork& network,
                const OutputOptions& options);

} // namespace powerline
} // namespace linelet
