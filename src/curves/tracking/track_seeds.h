// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <linelet/support/progress_monitor.h>

#include "curve_track.h"

namespace linelet {

/** \brief Measures the multi-scale shape of all points of \a scene.
 *
 * A surface runs through a point whose neighborhood is planar and grows like one over
 * three scales in a row. Curves may run through the others if some scale is linear: one
 * seed for the finest such scale and one for the coarsest.
 * \param[in,out] scene receives where surfaces are
 * \return where a curve may run, the best first */
std::vector<TrackSeed>
measureScene(TrackedScene& scene, unsigned threads, ProgressMonitor* monitor);

} // namespace linelet
