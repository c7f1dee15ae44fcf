// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <linelet/support/points.h>

#include "surroundings.h"

namespace linelet {

/** \brief A place from which a curve may be followed. */
struct TrackSeed {
  Index index = 0;    ///< a point of it
  Point at;           ///< a place of it
  Point direction;    ///< its tangent there, either way
  double radius = 0;  ///< over which it looks straight
  double density = 0; ///< points per length
  double noise = 0;   ///< standard deviation of the points about it, per coordinate
  double quality = 0; ///< by which seeds are ordered, the best largest
};

/// Least standard deviation of points about a curve, in D of the scene.
inline constexpr double least_track_noise = 0.03;

/** \brief How freely a curve may bend. */
struct TrackBending {
  double turn = 0.01; ///< standard deviation of its change of direction, radians, ...
  double points = 10; ///< ... over this many points
};

/** \brief A curve that was followed through its surroundings. */
struct Track {
  struct Member {
    Index index;
    double weight; ///< probability that the point is one of the curve
  };
  std::vector<Member> members; ///< along the curve
  Points path;                 ///< where the filter went, at the members
  double evidence = 0;         ///< log-likelihood ratio of curve to background
  double density = 0;          ///< points per length where it is visible
  double noise = 0;            ///< standard deviation about the curve, per coordinate

  /** \brief Number of its points: the sum of their probabilities. */
  double
  weight() const;
};

/** \brief Follows a curve from \a seed both ways by a Kalman filter with probabilistic
 * data association.
 *
 * Points of the curve are a Poisson process of some density along it, scattered about
 * it by normal noise, over a background that is measured around every stretch;
 * stretches may be hidden by what stands above them, so that few of their points are
 * seen (a hidden Markov chain). The evidence is the log-likelihood ratio of this to the
 * background alone, divided by the dispersion of the background (quasi-likelihood); of
 * curves as free as \a bending and stiffer ones, that of most evidence is returned. A
 * curve ends where continuing has lost more than \a patience of it, cut back to where
 * the evidence was greatest.
 * \param[in] most_points the curve ends after this many each way; 0: no limit
 * \param[in] promising evidence below which there is no second pass with the density
 * and noise learned in the first
 *
 * Bar-Shalom and Tse, Automatica 11 (1975). */
Track
followCurve(const TrackedScene& scene,
            const TrackSeed& seed,
            const TrackBending& bending,
            double patience,
            unsigned most_points = 0,
            double promising = 0);

} // namespace linelet
