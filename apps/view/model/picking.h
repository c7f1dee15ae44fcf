// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <vector>

#include <linelet/search/uniform_grid.h>

namespace linelet::view {

/** \brief What a click looks along: all places nearer to the ray than a radius that
 * grows from \ref radius by \ref spread for every unit of depth. */
struct Ray {
  Point origin = Point::Zero();
  Point direction = Point::UnitX(); ///< unit length
  double radius = 0;                ///< at the origin; a few pixels
  double spread = 0;                ///< 0 for parallel projection
};

/** \brief The point of \a grid that a click means: of those within the ray's reach, and
 * no deeper behind the foremost one than twice that reach there, the one nearest to
 * its axis; of equals the one of lowest index.
 * \param[in] depth no point is looked for beyond
 * \return its index, or UniformGrid::none */
Index
pick(const UniformGrid& grid, const Ray& ray, double depth);

/** \brief Indices of at most \a most of \a count points, chosen at random, ascending;
 * the same ones for the same numbers. */
Indices
randomSubset(std::size_t count, std::size_t most);

} // namespace linelet::view
