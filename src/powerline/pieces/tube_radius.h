// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

namespace linelet::powerline {

constexpr double widest_tube_seen = 1; ///< meters from an axis to what may belong to it
constexpr double tube_part = 0.95;     ///< of the points of a thing that its tube holds

/** \brief The distance from an axis that holds \ref tube_part of the points of what
 * runs along it, over a background that is as dense as the outer half of the tube that
 * was looked at.
 * \param[in] distances of all points up to \ref widest_tube_seen */
double
tubeRadius(std::vector<double> distances);

} // namespace linelet::powerline
