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

/** \brief Pairs of an edge and a point near it, grouped by edge, and what the E-step
 * computes for each. The arrays end with padding for vectors. */
class EdgePairs {
public:
  /** \param[in] grid of the points; must outlive the pairs */
  explicit EdgePairs(const UniformGrid& grid);

  /** \brief Collects the pairs of all edges of \a mixture again. */
  void
  collect(MixtureState& mixture);

  /** \brief Whether the noise has changed so much since then that pairs are missing or
   * many are superfluous. */
  bool
  areStale(const MixtureState& mixture) const;

  EdgePoints
  pointsOf(const MixtureEdge& edge) const;

  WorkArray<Index> index;              ///< of the point, sorted
  std::array<WorkArray<double>, 3> at; ///< coordinates of the point
  WorkArray<double> density;           ///< then responsibility
  /// With fixed-radius noise: the position of the source on the edge, and the mean and
  /// mean square of its distance from the point minus the radius.
  WorkArray<double> place, residual, spread;

private:
  void
  dropHollow(MixtureEdge& edge, double hollow);

  const UniformGrid& grid_;
  std::shared_ptr<const SortedArrays> sorted_; // of the grid
};

/** \brief \a edge in the form that the kernels take; the factor of its density stays
 * 0. */
EdgeShape
shapeOf(const MixtureEdge& edge);

} // namespace linelet
