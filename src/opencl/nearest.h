// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "slabs.h"

namespace linelet::opencl {

/** \brief Radii of the balls that hold a number of nearest points each.
 *
 * Cells are as wide as a ball of the usual size; what finds too few points in it is
 * tried again with wider ones, a few times.
 *
 * \param[in] points finite ones of the surface
 * \param[in] wanted how many points, by query; 0 for those that are not asked for
 * \param[in,out] times upload, grid and nearest are added to
 * \return by query, NaN where the radius was not found. A ball holds more points than
 * are wanted only where some are equally far, to the last digits of double. */
std::vector<double>
nearestRadii(Context& context,
             Slabs& slabs,
             const Points& surface,
             const Points& queries,
             const Indices& points,
             const std::vector<cl_uint>& wanted,
             StageTimes& times);

} // namespace linelet::opencl
