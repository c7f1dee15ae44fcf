// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <vector>

#include <linelet/support/points.h>
#include <linelet/support/visibility.h>

#include "point_passes.h"

namespace linelet {
namespace LINELET_PUBLIC clustering {

/** \brief The passes on the threads of this machine.
 * \param[in] points must outlive the result
 * \param[in] field integers of the field, empty if there is none */
std::unique_ptr<PointPasses>
hostPasses(const Points& points, std::vector<std::int32_t> field, int threads);

} // namespace clustering
} // namespace linelet
