// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "corridor_scene.h"

namespace linelet::bench::corridor {

/** \brief The high-voltage line from before the scan's start to beyond its end. */
void
addHighVoltageLine(Scene& scene, const CorridorSettings& settings, Random& random);

} // namespace linelet::bench::corridor
