// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Core>

#include <linelet/support/visibility.h>

namespace LINELET_PUBLIC linelet {

/** \brief Features of a neighborhood besides its shape factors (Weinmann et al. 2015),
 * with eigenvalues divided by their sum L, so that none depends on the unit or size of
 * the neighborhood.
 *
 * CloudCompare and jakteristics take the eigenvalues l of the unweighted covariance as
 * they are: their omnivariance is L times this one, their eigenentropy L (this one - ln
 * L). Their linearity, planarity and sphericity are (l3 - l2) / l3, (l2 - l1) / l3 and
 * l1 / l3, not Westin's. Surface variation and verticality are the same. The covariance
 * of a neighborhood is its tensor with constant weight and the mean as centroid. */
struct EigenFeatures {
  double verticality;       ///< 1 - |normal z|: 0 on level ground, 1 on a wall
  double omnivariance;      ///< cbrt(l1 l2 l3) / L, 0 to 1/3
  double eigenentropy;      ///< -sum e ln e with e = l / L, 0 to ln 3
  double surface_variation; ///< l1 / L, 0 to 1/3 (Pauly et al. 2002)
};

/** \brief The features of nonnegative eigenvalues l1 <= l2 <= l3 and the direction of
 * the smallest; all NaN if these are NaN or 0. */
inline EigenFeatures
eigenFeatures(const Eigen::Vector3d& values, const Eigen::Vector3d& normal)
{
  const double sum = values.sum();
  if (!(sum > 0)) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    return {nan, nan, nan, nan};
  }
  const Eigen::Vector3d e = values / sum;
  double entropy = 0;
  for (int i = 0; i < 3; ++i)
    entropy -= e[i] > 0 ? e[i] * std::log(e[i]) : 0;
  return {1 - std::min(1.0, std::abs(normal.z())),
          std::cbrt(e[0] * e[1] * e[2]),
          std::max(0.0, entropy),
          e[0]};
}

} // namespace linelet
