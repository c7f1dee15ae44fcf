// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <linelet/support/progress_monitor.h>

#include "curve_track.h"

namespace linelet {

/** \brief Seeds where the points of a curve lie farther apart than the next curve: no
 * ball around them is linear, but a narrow cylinder is.
 *
 * Around every point that no surface and no curve explains, the cylinder through each
 * of its neighbors is compared with the ball that contains it: it must hold more points
 * than the best of so many would by chance.
 * \param[in] points of the whole scene, by which chance is judged
 * \return at most one seed per point, the best first */
std::vector<TrackSeed>
seedsAlongDirections(const TrackedScene& scene,
                     double points,
                     unsigned threads,
                     ProgressMonitor* monitor);

} // namespace linelet
