// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <vector>

#include <linelet/features/linearity_graph.h>
#include <linelet/support/visibility.h>

namespace LINELET_PUBLIC linelet {

/** \brief Reads a linearity graph CL(k).
 *
 * Rules, where the papers are silent:
 * - A scale whose linearity is NaN is undefined; the graph consists of the others.
 * - A run of equal values (within \ref flat_linearity) is one extremum. It is a minimum
 *   if the graph is higher on both sides (ends of the graph are not minima), a maximum
 *   if it is lower on every side that exists; so a flat graph and a graph of one scale
 *   each have one maximum.
 * - Maxima are sought from the first scale on whose neighborhood has
 *   settings.min_neighbors points; j- does not reach below it.
 * - A runs from the first defined scale to the end of the last local minimum, else (or
 *   with AreaEnd::WholeGraph) to the end of the graph. Where it is 0 the fraction A_j/A
 *   is 1.
 * - The first term of the score is clamped between 0 and its weight, so that the score
 * of eq. 9 has three terms between 0 and 1.
 * - Of equal scores the smaller scale wins.
 *
 * \param[in] linearity CL at each scale, NaN where not defined
 * \param[in] neighbors points in the neighborhood at each scale, the point itself
 * included; not descending
 * \param[in] radii radius of each scale, ascending
 * \throws std::invalid_argument unless the three are of the same length */
LinearityGraph
readLinearityGraph(const std::vector<double>& linearity,
                   const std::vector<std::uint32_t>& neighbors,
                   const std::vector<double>& radii,
                   const LinearityGraphSettings& settings = {});

} // namespace linelet
