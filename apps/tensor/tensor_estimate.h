// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "neighbor_finder.h"

namespace linelet::apps {

/** \brief Says of long work beforehand how long it will take: of all that may be, by
 * the number of neighbors, measured on a few points. */
void
announceTensors(const Points& points,
                const TensorSettings& settings,
                const NeighborFinder& finder,
                const NeighborhoodSizes& sizes,
                Frame& frame);

/** \brief Runs the engine asked for. EngineOption::Auto becomes the one that ran; a
 * device that it chose and that fails is no reason to give up. */
std::vector<PointDistributionTensor>
estimate(const Points& points,
         TensorSettings& settings,
         NeighborFinder& finder,
         const NeighborhoodSizes& sizes,
         Frame& frame);

} // namespace linelet::apps
