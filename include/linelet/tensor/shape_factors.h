// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <limits>

#include <Eigen/Core>

#include <linelet/support/visibility.h>

namespace LINELET_PUBLIC linelet {

/** \brief Shape of a neighborhood (Westin et al. 1997); the three sum to 1. */
struct ShapeFactors {
  double linearity;  ///< CL = (l3 - l2) / L, 1 on a line
  double planarity;  ///< CP = 2 (l2 - l1) / L, 1 on a disc
  double sphericity; ///< CS = 3 l1 / L, 1 in a ball
};

/** \brief The shape factors of eigenvalues, L = l1 + l2 + l3.
 * \param[in] values l1 <= l2 <= l3, nonnegative
 * \param[in] extent distance of the farthest neighbor from the query point: an L
 * below the rounding error of such coordinates means that all neighbors coincide
 * \return NaN if L is 0, NaN, or within rounding of 0 */
inline ShapeFactors
shapeFactors(const Eigen::Vector3d& values, double extent = 0)
{
  constexpr double rounding = 64 * std::numeric_limits<double>::epsilon();
  const double sum = values.sum(), least = rounding * extent;
  if (!(sum > least * least)) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    return {nan, nan, nan};
  }
  return {(values[2] - values[1]) / sum,
          2 * (values[1] - values[0]) / sum,
          3 * values[0] / sum};
}

/** \brief The linearity of a symmetric \a tensor by the closed form of its eigenvalues,
 * for use on millions of tensors; see \ref eigenAnalysis for the loss of accuracy.
 * \return 0 if the trace vanishes */
double
linearityOf(const Eigen::Matrix3d& tensor);

} // namespace linelet
