// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>

#include "curve_track.h"
#include "curves/mixture/em_fit.h"

namespace linelet {

/** \brief The points that a track is refitted to. */
enum class FitTo {
  Surroundings, ///< all around it, against which a false curve loses
  Members       ///< its members alone, if the others are so many that they hide it
};

/** \brief The result of refitting a track. */
struct TrackFit {
  EmFit fit;                   ///< curves in the coordinates of the scene
  Indices points;              ///< the points of the scene that it was fitted to
  std::vector<char> explained; ///< per such point whether a curve made it
};

/** \brief Fits the mixture to the points around \a track: one curve along it, or as
 * many as its cross-section shows lines (\ref linesAlong), free to bend or stiff,
 * whichever the criterion prefers. No curve if none explains the points better than
 * their background does.
 * \param[in] clear that the track is a curve beyond doubt, so that lines are looked for
 * along a stiff fit, too; in clutter they would be found by chance */
TrackFit
fitTrack(const TrackedScene& scene,
         const Track& track,
         FitTo fit_to,
         bool clear,
         const std::function<bool()>& stop);

} // namespace linelet
