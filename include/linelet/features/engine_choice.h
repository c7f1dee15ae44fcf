// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>

#include <linelet/features/tensor_estimation.h>

namespace linelet {

/** \brief What the costs of the engines depend on. */
struct EngineWork {
  std::size_t points = 0;  ///< of the surface
  std::size_t queries = 0; ///< points around which neighborhoods are made
  double neighbors = 0;    ///< of a query, on average
  bool nearest = false;    ///< k nearest points rather than a radius
};

/** \brief What work on an OpenCL device costs, in seconds. */
struct DeviceCost {
  double start = 0; ///< opening the device and building the kernels
  double point = 0; ///< transfer, cells and sorting of a point
  double pair = 0;  ///< a query and one of its neighbors
};

/** \brief The work that settings mean for a cloud. The number of neighbors is counted
 * around a few queries among every m-th point, so that it takes no time worth speaking
 * of: it is good to a factor of two. */
EngineWork
engineWork(const Points& surface,
           const Points& queries,
           const TensorSettings& settings,
           const NeighborhoodSizes& sizes = {});

/** \brief Seconds that an engine needs for \a work, by a model of a few terms:
 *
 * - tree: 8e-9 n log2 n to build; a query 3e-7 and 4.5e-8 a neighbor
 * - grid: 3e-5, and 1e-7 a point; a query 3e-7 and 2e-9 a neighbor; k nearest points
 *   are none of its strengths: as the tree, and the grid to build
 * - OpenCL: \a device
 *
 * The constants were measured with one thread of an EPYC (Genoa) on rolling ground of
 * 100 to 200,000 points with 10 to 5,000 neighbors. They hold to a factor of two,
 * which is closer than the engines are to each other where the choice matters. */
double
estimatedSeconds(Engine engine,
                 const EngineWork& work,
                 const DeviceCost* device = nullptr);

/** \brief The cheapest engine. A device has to beat the grid on eight threads, whatever
 * this machine has: the choice depends on the work alone. */
Engine
cheapestEngine(const EngineWork& work, const DeviceCost* device = nullptr);

/** \brief The engine of \a settings; for Engine::Auto, the cheapest one.
 * \param[in] device where there is one that may be chosen */
Engine
chosenEngine(const Points& surface,
             const Points& queries,
             const TensorSettings& settings,
             const NeighborhoodSizes& sizes = {},
             const DeviceCost* device = nullptr);

} // namespace linelet
