// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <linelet/support/points.h>

#include "em_kernels.h"

namespace linelet {

/** \brief Noise of about one length: distances of points from their sources are
 * normally distributed around a radius. */
struct FixedRadius {
  double radius;
  double width; ///< standard deviation
};

/** \brief For pairs of an edge and a point, one array each: means over the positions on
 * the edge where the point may come from. */
struct FixedRadiusMeans {
  double* place;    ///< along the edge
  double* residual; ///< distance minus the radius
  double* spread;   ///< the square of that
};

/** \brief The inner loops of the fit with fixed-radius noise. Arrays of pairs have the
 * padding of \ref EdgePoints, which is overwritten. */
struct FixedRadiusKernels {
  /** \brief The density of \a edge at the points, as if all distances were the radius,
   * and the corresponding means. The variance of \a edge is not used. */
  void (*densities)(const EdgeShape& edge,
                    const FixedRadius& noise,
                    const EdgePoints& points,
                    double* density,
                    const FixedRadiusMeans& means);

  /** \brief Sums over the points like EmKernels::sums: each point pulls its source
   * along the line between them, to where their distance is the radius.
   * \param[in] sorted_index of each point, its index in \a information */
  EdgeSums (*sums)(const EdgeShape& edge,
                   const FixedRadius& noise,
                   const EdgePoints& points,
                   const double* share,
                   const FixedRadiusMeans& means,
                   const Index* sorted_index,
                   const double* information,
                   bool front,
                   bool back);
};

/** \brief The kernels for this machine. */
const FixedRadiusKernels&
fixedRadiusKernels();

} // namespace linelet
