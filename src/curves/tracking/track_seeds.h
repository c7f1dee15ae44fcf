// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <linelet/support/progress_monitor.h>

#include "curve_track.h"

namespace linelet {

/** \brief The points of a scene by the shapes of their neighborhoods over scale. */
struct ScenePoints {
  std::vector<char> surface;    ///< per point, whether a surface runs through it
  std::vector<TrackSeed> seeds; ///< where a curve may run, the best first
};

/** \brief Measures the multi-scale shape of all \a points, among themselves.
 *
 * A surface runs through a point whose neighborhood is planar and grows like one over
 * three scales in a row. Curves may run through the others where some scale is linear:
 * a seed for the finest such scale and one for the coarsest.
 * \param[in] unit D */
ScenePoints
measureScene(const Points& points,
             const UniformGrid& grid,
             double unit,
             unsigned threads,
             ProgressMonitor* monitor);

} // namespace linelet
