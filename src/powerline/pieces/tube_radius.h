// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

namespace linelet::powerline {

constexpr double widest_tube_seen = 1; ///< meters, from an axis to its points
/// Share of the points of an object that its tube holds
constexpr double tube_part = 0.95;

/** \brief The distance from an axis that holds \ref tube_part of the points of the
 * object along it, over a background with the density of the outer half of the tube
 * examined.
 * \param[in] distances of all points up to \ref widest_tube_seen */
double
tubeRadius(std::vector<double> distances);

} // namespace linelet::powerline
