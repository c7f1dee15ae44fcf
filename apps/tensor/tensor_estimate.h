// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "neighbor_finder.h"

namespace linelet::apps {

/** \brief Announces how long slow work will take; it is slow with many neighbors, and
 * its time is measured on a few points. */
void
announceTensors(const Points& points,
                const TensorSettings& settings,
                const NeighborFinder& finder,
                const NeighborhoodSizes& sizes,
                Frame& frame);

/** \brief Runs the requested engine. EngineOption::Auto becomes the one that ran; if
 * the device it chose fails, another engine takes over. */
std::vector<PointDistributionTensor>
estimate(const Points& points,
         TensorSettings& settings,
         NeighborFinder& finder,
         const NeighborhoodSizes& sizes,
         Frame& frame);

} // namespace linelet::apps
