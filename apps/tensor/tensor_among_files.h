// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <vector>

#include "cloud_files.h"
#include "neighbor_finder.h"
#include "size_fields.h"

namespace linelet::apps {

/** \brief The records of the points of file \a number, whose neighbors may be in other
 * files. */
std::vector<PointDistributionTensor>
estimateAmongOthers(CloudInput& input,
                    std::size_t number,
                    const io::Cloud& cloud,
                    const io::UsablePoints& usable,
                    TensorSettings& settings,
                    NeighborFinder& finder,
                    const SizeFields& fields,
                    Frame& frame);

} // namespace linelet::apps
