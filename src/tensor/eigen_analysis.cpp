// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/tensor/eigen_analysis.h>

#include <limits>

#include <Eigen/Eigenvalues>

namespace linelet {

EigenSystem
eigenAnalysis(const SymmetricTensor& tensor)
{
  const Eigen::Matrix3d matrix = tensor.matrix();
  EigenSystem system;
  if (!matrix.allFinite()) {
    system.values.setConstant(std::numeric_limits<double>::quiet_NaN());
    system.vectors.setConstant(std::numeric_limits<double>::quiet_NaN());
    return system;
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(matrix);
  system.values = solver.eigenvalues().cwiseMax(0.0);
  system.vectors = solver.eigenvectors();
  for (int column = 0; column < 3; ++column) {
    Eigen::Index largest = 0;
    system.vectors.col(column).cwiseAbs().maxCoeff(&largest);
    if (system.vectors(largest, column) < 0)
      system.vectors.col(column) *= -1;
  }
  return system;
}

} // namespace linelet
