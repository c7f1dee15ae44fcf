// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <linelet/features/centroid_shift.h>
#include <linelet/io/cloud.h>
#include <linelet/io/usable_points.h>

#include "frame.h"

namespace linelet::apps {

/** \brief The usable points of \a cloud; if \a shift has a radius, they are moved to
 * the centroids of their neighbors, in \a cloud as well. */
Points
shiftedPoints(io::Cloud& cloud,
              const io::UsablePoints& usable,
              const CentroidShiftSettings& shift,
              Frame& frame);

} // namespace linelet::apps
