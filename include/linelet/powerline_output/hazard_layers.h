// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <linelet/io/cloud.h>
#include <linelet/io/vector_file.h>
#include <linelet/powerline/hazards.h>
#include <linelet/support/visibility.h>

namespace linelet {
namespace LINELET_PUBLIC powerline {

/** \brief The hazards of all states as layers in world coordinates: `clearances` (lines
 * along the wires), `clearance_areas` (polygons in plan, the same attributes),
 * `crossings` (from the upper wire to the lower, where they are closest) and `fall_in`
 * (from the top of the tree to the wire), each feature with its ids, distances,
 * severity and the coordinates of both ends. Empty layers are included. */
std::vector<io::VectorLayer>
hazardLayers(const io::Cloud& cloud, const std::vector<Hazards>& states);

} // namespace powerline
} // namespace linelet
