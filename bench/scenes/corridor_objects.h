// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "corridor_scene.h"

namespace linelet::bench::corridor {

/** \brief Houses, cranes, fences, trees and bushes beside (and some below) the lines.
 */
void
addObjects(Scene& scene, const CorridorSettings& settings, Random& random);

} // namespace linelet::bench::corridor
