// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <vector>

#include <linelet/powerline/ground.h>
#include <linelet/support/points.h>
#include <linelet/support/progress_monitor.h>

namespace linelet::powerline {

/** \brief Terrain under a cloud.
 *
 * Lowest points of 2 m cells, lonely low outliers lifted, then a progressive
 * morphological filter (Zhang et al. 2003): openings of growing size lower what stands
 * out from its surroundings by more than terrain can. What was lowered is filled from
 * the terrain around, and the raster refined to the mean height of the points next to
 * it.
 * \param[in] classes empty, or one per point
 * \param[in] use_classes take points of class 2 for the terrain, where there are any
 * \param[in] on_surfaces what lies on no surface is no terrain; not where there is none
 * to be seen, see \ref showsTerrain
 * \param[in] threads 0: all */
Ground
findGround(const Points& points,
           const std::vector<std::uint8_t>& classes,
           bool use_classes,
           const ProgressMonitor* monitor = nullptr,
           bool on_surfaces = true,
           unsigned threads = 0);

} // namespace linelet::powerline
