// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>

#include "curve_track.h"
#include "curves/mixture/em_fit.h"

namespace linelet {

/** \brief The result of refitting a track. */
struct TrackFit {
  EmFit fit;                   ///< curves in the coordinates of the scene
  Indices points;              ///< the points of the scene that it was fitted to
  std::vector<char> explained; ///< per such point whether a curve made it
};

/** \brief Refits a track: the mixture is fitted to points around it, as one curve along
 * it, or as many as its cross-section shows lines (\ref linesAlong), free to bend or
 * stiff, whichever the criterion prefers. No curve if none explains the points better
 * than their background does. */
class TrackFitter {
public:
  /** \param[in] scene, track must outlive the fitter
   * \param[in] clear that the track is a curve beyond doubt, so that lines are looked
   * for along a stiff fit, too; in clutter they would be found by chance
   * \param[in] stop as of \ref EmFitter; called by several threads */
  TrackFitter(const TrackedScene& scene,
              const Track& track,
              bool clear,
              unsigned threads,
              std::function<bool()> stop);

  /** \brief Fits to all points around the track, against which a false curve loses. No
   * more of them can be outliers than the density farther off suggests. */
  TrackFit
  toSurroundings() const;

  /** \brief Fits to the members of the track alone, if there are so many others that
   * they hide it. */
  TrackFit
  toMembers() const;

  /** \brief Takes in more surroundings if the points go on beyond them, thinning out:
   * their noise is wider than the track's. Those of another curve lie beyond a gap.
   * \return whether it did */
  bool
  widen();

private:
  /** \brief Fits to the points of these \a indices.
   * \param[in] background expected number of points that belong to no curve */
  TrackFit
  fit(Indices indices, double background) const;

  const TrackedScene& scene_;
  const Track& track_;
  bool clear_;
  unsigned threads_;
  std::function<bool()> stop_;
  ModelCurve start_;
  double distance_; ///< of the points from the start, at most
};

} // namespace linelet
