// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "curve_track.h"
#include "track_fit.h"

namespace linelet {

/** \brief Takes the points that \a fit explains out of the search for other curves.
 *
 * Members of \a track that lie beside the refit by no more than the tails of its noise
 * go with them: followed once more, they would give the same curve again. Those farther
 * off stay, since the filter may have wandered between curves side by side of which the
 * refit is one. */
void
explainPoints(TrackedScene& scene, const Track& track, const TrackFit& fit);

} // namespace linelet
