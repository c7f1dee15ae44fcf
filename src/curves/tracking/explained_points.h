// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "curve_track.h"
#include "track_fit.h"

namespace linelet {

/** \brief Standard deviations of a curve's noise within which points are its own,
 * whatever else is around it. */
inline constexpr double own_width = 3;

/** \brief Removes the points that \a fit explains from the search for other curves.
 *
 * Members of \a track that lie beside the refit by no more than the tails of its noise
 * go with them: they would only give the same curve again. Those farther off stay,
 * since the filter may have wandered between parallel curves of which the refit is only
 * one. A \a clear curve also owns all points of its width: a wide beam spreads them
 * evenly, and those at the edges, which a normal distribution leaves over, would line
 * up as further curves. */
void
explainPoints(TrackedScene& scene, const Track& track, const TrackFit& fit, bool clear);

/** \brief Drops the curves of which most points are also those of clearer ones, and
 * which lack the evidence \a needed without them. */
ModelCurves
withoutExplained(const TrackedScene& scene, ModelCurves curves, double needed);

} // namespace linelet
