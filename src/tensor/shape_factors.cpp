// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/tensor/shape_factors.h>

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

namespace linelet {

double
linearityOf(const Eigen::Matrix3d& m)
{
  const double trace = m.trace();
  if (!(trace > 0))
    return 0;
  // Eigenvalues of a symmetric 3x3 matrix by the trigonometric formula.
  const double q = trace / 3;
  const double off = m(0, 1) * m(0, 1) + m(0, 2) * m(0, 2) + m(1, 2) * m(1, 2);
  const double p2 = (m(0, 0) - q) * (m(0, 0) - q) + (m(1, 1) - q) * (m(1, 1) - q) +
                    (m(2, 2) - q) * (m(2, 2) - q) + 2 * off;
  const double p = std::sqrt(p2 / 6);
  if (!(p > 1e-12 * q))
    return 0;
  const Eigen::Matrix3d b = (m - q * Eigen::Matrix3d::Identity()) / p;
  const double r = std::clamp(b.determinant() / 2, -1.0, 1.0);
  // The largest is q + 2p cos(phi), the middle one q + 2p cos(phi - 2 pi / 3), where
  // phi = acos(r) / 3.
  return 2 * std::sqrt(3.0) * p * std::sin(std::acos(-r) / 3) / trace;
}

} // namespace linelet
