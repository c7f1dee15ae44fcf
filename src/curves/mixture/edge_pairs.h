// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>
#include <memory>

#include <linelet/search/uniform_grid.h>

#include "em_kernels.h"
#include "mixture_state.h"
#include "work_array.h"

namespace linelet {

struct SortedArrays;

/** \brief Pairs of an edge and a point near it, those of an edge together, and what the
 * E-step finds out about each. The arrays end with padding for vectors. */
class EdgePairs {
public:
  /** \param[in] grid of the points; must outlive the pairs */
  explicit EdgePairs(const UniformGrid& grid);

  /** \brief Finds the pairs of all edges of \a mixture anew. */
  void
  collect(MixtureState& mixture);

  /** \brief Whether the noise has changed so much since that pairs are missing, or many
   * say nothing. */
  bool
  areStale(const MixtureState& mixture) const;

  EdgePoints
  pointsOf(const MixtureEdge& edge) const;

  WorkArray<Index> index;              ///< of the point, sorted
  std::array<WorkArray<double>, 3> at; ///< coordinates of the point
  WorkArray<double> density;           ///< then responsibility
  /// With fixed-radius noise: the place of the source on the edge, mean and mean square
  /// of what its distance from the point differs from the radius.
  WorkArray<double> place, residual, spread;

private:
  void
  dropHollow(MixtureEdge& edge, double hollow);

  const UniformGrid& grid_;
  std::shared_ptr<const SortedArrays> sorted_; // of the grid
};

/** \brief \a edge as the kernels take it; the factor of its density is left 0. */
EdgeShape
shapeOf(const MixtureEdge& edge);

} // namespace linelet
