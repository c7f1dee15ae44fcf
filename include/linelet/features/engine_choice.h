// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>

#include <linelet/features/tensor_settings.h>
#include <linelet/support/points.h>
#include <linelet/support/visibility.h>

namespace LINELET_PUBLIC linelet {

/** \brief What the costs of the engines depend on. */
struct EngineWork {
  std::size_t points = 0;  ///< of the surface
  std::size_t queries = 0; ///< points around which neighborhoods are made
  double neighbors = 0;    ///< of a query, on average
  bool nearest = false;    ///< k nearest points rather than a radius
};

/** \brief The work that settings require for a cloud. The number of neighbors is
 * estimated at a few queries among every m-th point, which takes negligible time and is
 * accurate within a factor of two. */
EngineWork
engineWork(const Points& surface,
           const Points& queries,
           const TensorSettings& settings,
           const NeighborhoodSizes& sizes = {});

/** \brief Seconds that an engine needs for \a work, by a model of a few terms:
 *
 * - tree: 8e-9 n log2 n to build; 3e-7 per query and 4.5e-8 per neighbor
 * - grid: 3e-5, 1e-7 per point, 3e-7 per query and 2e-9 per neighbor; for k nearest
 *   points it falls back to the tree, which costs the grid on top
 *
 * The constants were measured with one thread of an EPYC (Genoa) on rolling ground of
 * 100 to 200,000 points with 10 to 5,000 neighbors. They hold within a factor of two;
 * where the choice matters, engines differ by more. */
double
estimatedSeconds(Engine engine, const EngineWork& work);

/** \brief The cheapest engine. */
Engine
cheapestEngine(const EngineWork& work);

/** \brief The engine of \a settings; for Engine::Auto, the cheapest one. */
Engine
chosenEngine(const Points& surface,
             const Points& queries,
             const TensorSettings& settings,
             const NeighborhoodSizes& sizes = {});

} // namespace linelet
