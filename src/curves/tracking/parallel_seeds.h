// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <linelet/support/progress_monitor.h>

#include "curve_track.h"
#include "curves/ridges/model_curve.h"

namespace linelet {

/** \brief Seeds of curves that run parallel to a known one, beside it and beyond its
 * ends: where crowns hide a wire from every ball, its points still gather at one offset
 * from the wire next to it.
 *
 * Points are projected along stretches of the curves. Where a cell of the cross-section
 * holds more of them than the best of so many would by chance, judged by the cells
 * around it, a curve may run.
 * \param[in] beyond how far beyond the ends, in spacings of a curve's points
 * \return the best first */
std::vector<TrackSeed>
seedsAlongCurves(const TrackedScene& scene,
                 const ModelCurves& curves,
                 double beyond,
                 unsigned threads,
                 ProgressMonitor* monitor = nullptr);

} // namespace linelet
