// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <vector>

#include <linelet/search/uniform_grid.h>

namespace linelet::view {

/** \brief The cone under a click: all places nearer to the ray than a radius that grows
 * from \ref radius by \ref spread per unit of depth. */
struct Ray {
  Point origin = Point::Zero();
  Point direction = Point::UnitX(); ///< unit length
  double radius = 0;                ///< at the origin; a few pixels
  double spread = 0;                ///< 0 for parallel projection
};

/** \brief The point of \a grid that a click selects: of those inside the cone, and no
 * deeper behind the foremost one than twice the cone's radius there, the one nearest to
 * its axis; ties go to the lowest index.
 * \param[in] depth no point is searched for beyond it
 * \return its index, or UniformGrid::none */
Index
pick(const UniformGrid& grid, const Ray& ray, double depth);

/** \brief Indices of at most \a most of \a count points, chosen at random, ascending;
 * always the same for the same numbers. */
Indices
randomSubset(std::size_t count, std::size_t most);

} // namespace linelet::view
