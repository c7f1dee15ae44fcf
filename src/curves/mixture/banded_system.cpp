// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "banded_system.h"

#include <cmath>

#include <Eigen/LU>

namespace linelet {

void
BandedSystem::reset(std::size_t nodes, bool closed)
{
  closed_ = closed;
  nodes_ = nodes;
  band_ = closed ? nodes - 2 : nodes;
  diagonal_.assign(nodes, 0);
  next_.assign(nodes, 0);
  after_next_.assign(nodes, 0);
}

void
BandedSystem::factorize()
{
  pivot_.resize(band_);
  inverse_pivot_.resize(band_);
  lower1_.assign(band_, 0);
  lower2_.assign(band_, 0);
  for (std::size_t i = 0; i < band_; ++i) {
    double pivot = diagonal_[i];
    if (i > 1) {
      lower2_[i] = after_next_[i - 2] * inverse_pivot_[i - 2];
      pivot -= lower2_[i] * lower2_[i] * pivot_[i - 2];
    }
    if (i > 0) {
      double coupling = next_[i - 1];
      if (i > 1)
        coupling -= lower2_[i] * pivot_[i - 2] * lower1_[i - 1];
      lower1_[i] = coupling * inverse_pivot_[i - 1];
      pivot -= lower1_[i] * lower1_[i] * pivot_[i - 1];
    }
    pivot_[i] = pivot;
    inverse_pivot_[i] = 1 / pivot;
  }
  if (!closed_)
    return;

  const std::size_t n = nodes_;
  border_.assign(band_, Eigen::Vector2d::Zero());
  border_[band_ - 1] += Eigen::Vector2d(next_[n - 3], after_next_[n - 3]);
  border_[band_ - 2] += Eigen::Vector2d(after_next_[n - 4], 0);
  border_[0] += Eigen::Vector2d(after_next_[n - 2], next_[n - 1]);
  border_[1] += Eigen::Vector2d(0, after_next_[n - 1]);
  const std::array<std::size_t, 4> coupled = {0, 1, band_ - 2, band_ - 1};
  std::array<Eigen::Vector2d, 4> coupling;
  for (std::size_t k = 0; k < 4; ++k)
    coupling[k] = border_[coupled[k]];
  bandSolve(border_);
  Eigen::Matrix2d corner;
  corner << diagonal_[n - 2], next_[n - 2], next_[n - 2], diagonal_[n - 1];
  for (std::size_t k = 0; k < 4; ++k)
    corner -= coupling[k] * border_[coupled[k]].transpose();
  corner_inverse_ = corner.inverse();
}

template <class Vector>
void
BandedSystem::bandSolve(std::vector<Vector>& x) const
{
  for (std::size_t i = 0; i < band_; ++i) {
    if (i > 0)
      x[i] -= lower1_[i] * x[i - 1];
    if (i > 1)
      x[i] -= lower2_[i] * x[i - 2];
  }
  for (std::size_t i = band_; i-- > 0;) {
    x[i] *= inverse_pivot_[i];
    if (i + 1 < band_)
      x[i] -= lower1_[i + 1] * x[i + 1];
    if (i + 2 < band_)
      x[i] -= lower2_[i + 2] * x[i + 2];
  }
}

void
BandedSystem::solve(Points& x)
{
  factorize();
  if (!closed_) {
    bandSolve(x);
    return;
  }
  const std::size_t n = nodes_;
  // The border's own right-hand side less the band's contribution: C^T B^-1 b is (B^-1
  // C)^T b.
  Eigen::Matrix<double, 2, 3> edge;
  edge.row(0) = x[n - 2].transpose();
  edge.row(1) = x[n - 1].transpose();
  for (std::size_t i = 0; i < band_; ++i)
    edge -= border_[i] * x[i].transpose();
  edge = (corner_inverse_ * edge).eval();
  bandSolve(x);
  for (std::size_t i = 0; i < band_; ++i)
    x[i] -= edge.transpose() * border_[i];
  x[n - 2] = edge.row(0).transpose();
  x[n - 1] = edge.row(1).transpose();
}

double
BandedSystem::logDeterminant() const
{
  double sum = closed_ ? -std::log(corner_inverse_.determinant()) : 0;
  for (const double pivot : pivot_)
    sum += std::log(pivot);
  return sum;
}

void
BandedSystem::inverseBand(std::vector<double>& diagonal,
                          std::vector<double>& next,
                          std::vector<double>& after_next) const
{
  // Takahashi's recursion: entries of the inverse inside the band, from the last up.
  diagonal.assign(nodes_, 0);
  next.assign(nodes_, 0);
  after_next.assign(nodes_, 0);
  for (std::size_t i = band_; i-- > 0;) {
    const double l1 = i + 1 < band_ ? lower1_[i + 1] : 0;
    const double l2 = i + 2 < band_ ? lower2_[i + 2] : 0;
    double value = inverse_pivot_[i];
    if (i + 2 < band_)
      after_next[i] = -(l1 * next[i + 1] + l2 * diagonal[i + 2]);
    if (i + 1 < band_) {
      next[i] = -(l1 * diagonal[i + 1] + (i + 2 < band_ ? l2 * next[i + 1] : 0));
      value -= l1 * next[i];
    }
    if (i + 2 < band_)
      value -= l2 * after_next[i];
    diagonal[i] = value;
  }
  if (!closed_)
    return;
  const std::size_t n = nodes_;
  std::vector<Eigen::Vector2d> z(n);
  for (std::size_t i = 0; i < band_; ++i) {
    z[i] = corner_inverse_ * border_[i];
    diagonal[i] += border_[i].dot(z[i]);
  }
  for (std::size_t i = 0; i + 1 < band_; ++i)
    next[i] += border_[i].dot(z[i + 1]);
  for (std::size_t i = 0; i + 2 < band_; ++i)
    after_next[i] += border_[i].dot(z[i + 2]);
  after_next[n - 4] = -z[n - 4].x();
  after_next[n - 3] = -z[n - 3].y();
  after_next[n - 2] = -z[0].x();
  after_next[n - 1] = -z[1].y();
  diagonal[n - 2] = corner_inverse_(0, 0);
  diagonal[n - 1] = corner_inverse_(1, 1);
  next[n - 2] = corner_inverse_(0, 1);
  next[n - 3] = -z[n - 3].x();
  next[n - 1] = -z[0].y();
}

} // namespace linelet
