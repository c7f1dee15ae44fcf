// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "slabs.h"

namespace linelet::opencl {

/** \brief Radii of the balls that hold the given numbers of nearest points.
 *
 * Cells are as wide as a ball of the usual size; queries that find too few points are
 * repeated with wider cells, a few times.
 *
 * \param[in] points finite ones of the surface
 * \param[in] wanted number of points per query; 0 for queries to skip
 * \param[in,out] times upload, grid and nearest are added to
 * \return radius per query, NaN if not found. A ball holds more points than wanted only
 * if some are equally far to the last digits of double. */
std::vector<double>
nearestRadii(Context& context,
             Slabs& slabs,
             const Points& surface,
             const Points& queries,
             const Indices& points,
             const std::vector<cl_uint>& wanted,
             StageTimes& times);

} // namespace linelet::opencl
