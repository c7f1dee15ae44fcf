// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>

#include <linelet/support/points.h>

namespace linelet::benchmarking {

/** \brief Where the points of a benchmark lie, one per unit of volume or of area. */
enum class Scene {
  Volume, ///< uniform in a cube
  Surface ///< uniform on rolling ground, like a LiDAR tile
};

/** \brief The order of the points in memory. */
enum class Order {
  Shuffled, ///< none: neighbors lie anywhere
  Sorted    ///< along a scan: neighbors are close
};

/** \brief Points of a scene; the same for the same arguments. */
const Points&
scene(Scene scene, std::size_t count, Order order);

/** \brief Radius at which a point away from the border has that many neighbors. */
double
radiusFor(Scene scene, double neighbors);

/** \brief Process CPU seconds so far: unlike wall-clock time, they hardly depend on
 * other work on the machine. */
double
cpuSeconds();

/** \brief A clock for work in that many threads: \ref cpuSeconds for one, the wall
 * clock for more, whose waiting is not work. */
double
seconds(unsigned threads);

} // namespace linelet::benchmarking
