// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <vector>

#include <linelet/features/linearity_graph.h>
#include <linelet/features/multi_scale_types.h>

namespace linelet {

/** \brief The record of a point from its graphs.
 * \param[in] here points of the surface at the very place of the query, which are among
 * the neighbours of every scale */
MultiScaleShape
summarise(const ShapeGraph& graph,
          std::uint32_t here,
          const std::vector<double>& radii,
          const LinearityGraphSettings& settings);

} // namespace linelet
