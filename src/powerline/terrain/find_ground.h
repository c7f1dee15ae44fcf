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
 * Lowest points of 2 m cells, isolated low outliers raised, then a progressive
 * morphological filter (Zhang et al. 2003): openings of growing size lower what rises
 * above its surroundings by more than terrain can. Lowered cells are filled from the
 * terrain around, and the raster is refined to the mean height of the points close to
 * it.
 * \param[in] classes empty, or one per point
 * \param[in] use_classes take the terrain from points of class 2, if there are any
 * \param[in] on_surfaces accept only surfaces as terrain; false if the cloud shows no
 * terrain, see \ref showsTerrain
 * \param[in] threads 0: all */
Ground
findGround(const Points& points,
           const std::vector<std::uint8_t>& classes,
           bool use_classes,
           const ProgressMonitor* monitor = nullptr,
           bool on_surfaces = true,
           unsigned threads = 0);

} // namespace linelet::powerline
