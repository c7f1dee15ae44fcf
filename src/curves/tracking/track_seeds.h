// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <linelet/support/progress_monitor.h>

#include "curve_track.h"

namespace linelet {

/** \brief Where curves may run, the best first. */
struct SceneSeeds {
  std::vector<TrackSeed> open; ///< on no surface
  std::vector<TrackSeed> on_sparse_surfaces;
  /// Points of surfaces that are sampled far more sparsely than others of the scene:
  /// curves side by side look like one at scales larger than their distances.
  Indices sparse_surfaces;
};

/** \brief Measures the multi-scale shape of all points of \a scene.
 *
 * A surface runs through a point whose neighborhood is planar and grows like one over
 * three scales in a row. Curves may run through the others if some scale is linear: one
 * seed for the finest such scale and one for the coarsest.
 * \param[in,out] scene receives where surfaces are, sparse ones included */
SceneSeeds
measureScene(TrackedScene& scene, unsigned threads, ProgressMonitor* monitor);

} // namespace linelet
