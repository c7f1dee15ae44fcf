// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/features/fourth_order.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Eigenvalues>

#include <linelet/tensor/eigen_analysis.h>
#include <linelet/tensor/shape_factors.h>

namespace linelet {

namespace {

const double root2 = std::sqrt(2.0);

/// Row of Mandel's notation that holds the entry (i, j).
constexpr int mandel_row[3][3] = {{0, 5, 4}, {5, 1, 3}, {4, 3, 2}};

double
mandelFactor(int i, int j)
{
  return i == j ? 1 : root2;
}

double
weightOf(const ShapeFactors& factors, ScaleWeight weight)
{
  switch (weight) {
  case ScaleWeight::Linearity:
    return factors.linearity;
  case ScaleWeight::Planarity:
    return factors.planarity;
  case ScaleWeight::Sphericity:
    return factors.sphericity;
  case ScaleWeight::Uniform:
    break;
  }
  return 1;
}

} // namespace

MandelVector
mandel(const Eigen::Matrix3d& t)
{
  MandelVector v;
  v << t(0, 0), t(1, 1), t(2, 2), root2 * t(1, 2), root2 * t(0, 2), root2 * t(0, 1);
  return v;
}

Eigen::Matrix3d
fromMandel(const MandelVector& v)
{
  Eigen::Matrix3d t;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      t(i, j) = v[mandel_row[i][j]] / mandelFactor(i, j);
  return t;
}

void
FourthOrderTensor::add(double weight, const Eigen::Matrix3d& t)
{
  const MandelVector v = mandel(t);
  matrix_ += weight * v * v.transpose();
}

double
FourthOrderTensor::operator()(int i, int j, int k, int l) const
{
  return matrix_(mandel_row[i][j], mandel_row[k][l]) /
         (mandelFactor(i, j) * mandelFactor(k, l));
}

std::array<double, 21>
FourthOrderTensor::components() const
{
  std::array<double, 21> result{};
  std::size_t place = 0;
  for (int row = 0; row < 6; ++row)
    for (int column = row; column < 6; ++column)
      result[place++] = matrix_(row, column);
  return result;
}

FourthOrderTensor
FourthOrderTensor::fromComponents(const std::array<double, 21>& components)
{
  Matrix matrix;
  std::size_t place = 0;
  for (int row = 0; row < 6; ++row)
    for (int column = row; column < 6; ++column)
      matrix(row, column) = matrix(column, row) = components[place++];
  return FourthOrderTensor(matrix);
}

FourthOrderTensor
FourthOrderTensor::rotated(const Eigen::Matrix3d& q) const
{
  // In this notation, rotating second-order tensors by Q is an orthogonal 6x6 matrix.
  Matrix turn;
  for (int column = 0; column < 6; ++column) {
    const Eigen::Matrix3d unit = fromMandel(MandelVector::Unit(column));
    turn.col(column) = mandel(q * unit * q.transpose());
  }
  return FourthOrderTensor(turn * matrix_ * turn.transpose());
}

FourthOrderTensor::EigenTensors
FourthOrderTensor::eigenTensors() const
{
  EigenTensors result;
  if (!matrix_.allFinite()) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    result.values.fill(nan);
    result.tensors.fill(Eigen::Matrix3d::Constant(nan));
    return result;
  }
  const Eigen::SelfAdjointEigenSolver<Matrix> solver(matrix_);
  for (int n = 0; n < 6; ++n) {
    const auto place = static_cast<std::size_t>(n);
    result.values[place] = solver.eigenvalues()[n];
    result.tensors[place] = fromMandel(solver.eigenvectors().col(n));
    if (result.tensors[place].trace() < 0)
      result.tensors[place] *= -1;
  }
  return result;
}

std::size_t
SymmetricFourthOrderTensor::place(int i, int j, int k, int l)
{
  // Sorted by the number of y and z together, then of z.
  const int beside_x = (i > 0) + (j > 0) + (k > 0) + (l > 0);
  const int z = (i > 1) + (j > 1) + (k > 1) + (l > 1);
  return static_cast<std::size_t>(beside_x * (beside_x + 1) / 2) +
         static_cast<std::size_t>(z);
}

SymmetricFourthOrderTensor::SymmetricFourthOrderTensor(const FourthOrderTensor& t)
{
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j)
      for (int k = j; k < 3; ++k)
        for (int l = k; l < 3; ++l) // the other orders are equal to one of these three
          components_[place(i, j, k, l)] =
              (t(i, j, k, l) + t(i, k, j, l) + t(i, l, j, k)) / 3;
}

double
SymmetricFourthOrderTensor::along(const Eigen::Vector3d& v) const
{
  double sum = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k)
        for (int l = 0; l < 3; ++l)
          sum += (*this)(i, j, k, l) * v[i] * v[j] * v[k] * v[l];
  return sum;
}

FourthOrderTensor
SymmetricFourthOrderTensor::expanded() const
{
  FourthOrderTensor::Matrix matrix;
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j)
      for (int k = 0; k < 3; ++k)
        for (int l = k; l < 3; ++l)
          matrix(mandel_row[i][j], mandel_row[k][l]) =
              (*this)(i, j, k, l) * mandelFactor(i, j) * mandelFactor(k, l);
  return FourthOrderTensor(matrix);
}

FourthOrderTensor
fourthOrderTensor(const std::vector<SymmetricTensor>& tensors, ScaleWeight weight)
{
  FourthOrderTensor sum;
  double total = 0;
  for (const SymmetricTensor& tensor : tensors) {
    const double w = weightOf(shapeFactors(eigenAnalysis(tensor).values), weight);
    if (std::isnan(w) || !(tensor.trace() > 0))
      continue;
    sum.add(w, tensor.matrix());
    total += w;
  }
  const double scale = total > 0 ? 1 / total : std::numeric_limits<double>::quiet_NaN();
  return FourthOrderTensor(sum.mandelMatrix() * scale);
}

} // namespace linelet
