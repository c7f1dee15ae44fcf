// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <linelet/search/uniform_grid.h>
#include <linelet/support/points.h>

#include "track_state.h"
#include "tube_points.h"

namespace linelet {

/** \brief A scene while it is searched for curves. */
struct TrackedScene {
  /** \param[in] points finite points; from now on in grid order */
  TrackedScene(const Points& points, double unit)
      : grid(points, row_size * unit),
        surface(points.size(), 0),
        taken(points.size(), 0),
        unit(unit)
  {
  }

  /** \brief The points, by their places in the grid: near ones lie together. */
  const Points&
  points() const
  {
    return grid.sortedPoints();
  }

  static constexpr double row_size = 4; ///< D; the fastest of 1 to 6

  UniformGrid grid;
  std::vector<char> surface; ///< per point, whether a surface runs through it
  std::vector<char> taken;   ///< per point, whether a curve explains it
  double unit;               ///< D
};

/** \brief What lies around the next stretch of a curve. */
struct Surroundings {
  struct Near {
    double place; ///< along the stretch
    Index index;
  };
  std::vector<Near> near; ///< points that may be of the curve, by their place
  double background = 0;  ///< points per volume that are expected without a curve
  /// Pearson's chi-square of the counts in parts of the ring against those of
  /// independent points, and its degrees of freedom.
  double chi_square = 0, freedom = 0;
  TubePoints tubed; ///< buffer of the points tested
};

/** \brief Examines the next \a length of a curve.
 * \param[in] gate points within this distance of the expected curve may be its own
 * \param[in] ring those beyond, up to this distance, give the background: points per
 * volume, and those of a surface that runs through the gate */
void
lookAhead(const TrackedScene& scene,
          const TrackState& state,
          double length,
          double gate,
          double ring,
          Surroundings& result);

} // namespace linelet
