// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <vector>

#include <linelet/support/points.h>

namespace linelet::powerline {

/** \brief Whether a cloud has any terrain: not so where somebody kept only the power
 * line. Then all classes are those of its parts, or what lies lowest, place by place,
 * is a line and no surface.
 * \param[in] classes empty, or one per point */
bool
showsTerrain(const Points& points, const std::vector<std::uint8_t>& classes);

} // namespace linelet::powerline
