// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <vector>

#include <linelet/support/points.h>

#include "scale_field.h"

namespace linelet {

/** \brief The points of each connected component with at least \a least points, in the
 * order of their first points. Points are linked across \a distance, times \a scales
 * where these exceed 1. */
std::vector<Indices>
connectedComponents(const Points& points,
                    double distance,
                    std::size_t least,
                    const ScaleField* scales = nullptr);

} // namespace linelet
