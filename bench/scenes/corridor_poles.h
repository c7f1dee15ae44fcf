// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "corridor_scene.h"

namespace linelet::bench::corridor {

/** \brief A line of poles across the corridor, number \a line (from 1). */
void
addPoleLine(Scene& scene, const CorridorSettings& settings, int line, Random& random);

} // namespace linelet::bench::corridor
