// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>

#include <linelet/support/points.h>

namespace linelet {

/** \brief Points near an edge, one array per coordinate; each with room for \ref
 * padding elements more than there are points. */
struct EdgePoints {
  static constexpr std::size_t padding = 16; ///< at least the lanes of any vector

  std::size_t count;
  const double* x;
  const double* y;
  const double* z;
};

/** \brief An edge of a mixture. */
struct EdgeShape {
  double from[3];
  double direction[3]; ///< unit vector
  double length;
  double variance; ///< of the noise, per coordinate
  double factor;   ///< of the density
  bool is_short;   ///< approximated by a normal density along the edge instead of the
                   ///< integral of the normal density over it
};

/** \brief Contribution of an edge to the normal equations of its two vertices a and b,
 * and to the noise: sums over its points, weighted by their shares. */
struct EdgeSums {
  double share = 0;  ///< of the points
  double square = 0; ///< of their distances from the edge's line, by shares
  double aa = 0, ab = 0, bb = 0;
  double at_a[3] = {0, 0, 0}, at_b[3] = {0, 0, 0};
};

/** \brief The inner loops of the fit over pairs of an edge and a point, for the
 * instruction set of the machine that runs them. */
struct EmKernels {
  /** \brief The density of \a edge at the points; the padding is overwritten too. */
  void (*densities)(const EdgeShape& edge, const EdgePoints& points, double* density);

  /** \brief Sums over the points, weighted by their \a share in the edge. At a free \a
   * front or \a back, points beyond the edge also pull its vertex along the curve. */
  EdgeSums (*sums)(const EdgeShape& edge,
                   const EdgePoints& points,
                   const double* share,
                   bool front,
                   bool back);

  /** \brief Replaces every one of \a count densities by its inverse (1e300 at most);
   * \return the sum of their logarithms. The padding is overwritten. */
  double (*invert)(double* densities, std::size_t count);

  /** \brief Multiplies the densities of an edge at \a count points by the \a inverse of
   * the total density at each, found at its \a sorted_index, which gives the edge's
   * share of the point. \return the sum of the shares */
  double (*share)(const double* inverse,
                  const Index* sorted_index,
                  double* densities,
                  std::size_t count);
};

/** \brief The kernels for this machine. */
const EmKernels&
emKernels();

} // namespace linelet
