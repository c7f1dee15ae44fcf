// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "curve_track.h"
#include "track_fit.h"

namespace linelet {

/** \brief Removes the points that \a fit explains from the search for other curves.
 *
 * Members of \a track that lie beside the refit by no more than the tails of its noise
 * go with them: they would only give the same curve again. Those farther off stay,
 * since the filter may have wandered between parallel curves of which the refit is only
 * one. */
void
explainPoints(TrackedScene& scene, const Track& track, const TrackFit& fit);

} // namespace linelet
