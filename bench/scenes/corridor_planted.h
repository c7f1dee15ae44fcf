// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "corridor_scene.h"

namespace linelet::bench::corridor {

/** \brief Places trees and houses too close to wires. */
std::vector<PlantedHazard>
plantHazards(Scene& scene, const CorridorSettings& settings, Random& random);

} // namespace linelet::bench::corridor
