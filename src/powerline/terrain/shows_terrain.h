// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <vector>

#include <linelet/support/points.h>

namespace linelet::powerline {

/** \brief Whether a cloud has any terrain: it has none if only the power line was kept.
 * Then all classes are those of its parts, or the lowest points everywhere form lines
 * rather than a surface.
 * \param[in] classes empty, or one per point */
bool
showsTerrain(const Points& points, const std::vector<std::uint8_t>& classes);

} // namespace linelet::powerline
