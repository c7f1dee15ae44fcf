// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <linelet/features/multi_scale_types.h>
#include <linelet/io/cloud.h>

namespace linelet::apps {

/** \brief Adds \a shapes, one per point, to \a cloud as attributes. */
void
addColumns(io::Cloud& cloud, const std::vector<MultiScaleShape>& shapes);

} // namespace linelet::apps
