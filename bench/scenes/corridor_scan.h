// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "corridor_scene.h"

namespace linelet::bench::corridor {

/** \brief Scans the scene strip by strip. Points are in the scene's own frame. */
CorridorScan
scan(const Scene& scene,
     const CorridorSettings& settings,
     Random& random,
     ProgressMonitor* monitor);

} // namespace linelet::bench::corridor
