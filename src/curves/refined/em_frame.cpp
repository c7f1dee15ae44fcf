// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <limits>

#include <Eigen/Eigenvalues>

#include "em_fit.h"

namespace linelet {

namespace {

// Of the box of the outliers, beside the diagonal of the points.
constexpr double least_width = 0.4;

} // namespace

CloudFrame
frameOf(const Points& points, double scale_unit)
{
  CloudFrame frame;
  frame.scale_unit = scale_unit;
  Point mean = Point::Zero(), low = points.front(), high = low;
  for (const Point& p : points) {
    mean += p;
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  mean /= static_cast<double>(points.size());
  frame.diagonal = (high - low).norm();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (const Point& p : points)
    covariance += (p - mean) * (p - mean).transpose();
  covariance /= static_cast<double>(points.size());
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(covariance);
  Point least = Point::Constant(std::numeric_limits<double>::infinity());
  Point most = -least;
  for (const Point& p : points) {
    const Point q = eigen.eigenvectors().transpose() * (p - mean);
    least = least.cwiseMin(q);
    most = most.cwiseMax(q);
  }
  const Point extent = most - least; // smallest first
  const double thin = 0.01 * scale_unit;
  frame.dimensions = extent.x() > thin ? 3 : 2;
  // A box that hugs a single straight tube of points would explain it as well as a
  // curve does, so outliers are given some width in every direction.
  const double width = least_width * frame.diagonal;
  frame.volume = std::max(extent.z(), width) * std::max(extent.y(), width);
  if (frame.dimensions == 3)
    frame.volume *= std::max(extent.x(), width);
  return frame;
}

} // namespace linelet
