// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>

#include <linelet/curves/curve_blocks.h>
#include <linelet/support/progress_monitor.h>

namespace linelet {

/** \brief The curves of a scene of several blocks, several blocks at a time.
 * \param[in] points all different
 * \param[in] settings with the traits of the cloud
 * \throws as \ref reconstructRefined */
CurveNetwork
curvesByBlocks(const Points& points,
               const RefinedSettings& settings,
               ProgressMonitor* monitor);

/** \brief The curves of one of several blocks, as \ref curvesOfBlock. */
CurvePart
ownCurves(const Points& points,
          const CurveBlocks& blocks,
          std::size_t block,
          const RefinedSettings& settings,
          ProgressMonitor* monitor);

} // namespace linelet
