// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "cloud_frame.h"

#include <algorithm>
#include <limits>

#include <Eigen/Eigenvalues>

namespace linelet {

namespace {

// Of the outliers' box, relative to the diagonal of the points.
constexpr double least_width = 0.4;
// Principal directions are arbitrary if the ratio of their variances is at least this.
constexpr double alike = 0.5;

/** \brief Volume (of two dimensions: area) of a box with the sides \a extent, smallest
 * first, none of them less than \a width. A box that hugs a single straight tube of
 * points would explain it as well as a curve does, so the box has some width in every
 * direction. */
double
volumeOf(const Point& extent, double width, int dimensions)
{
  const Point sides = extent.cwiseMax(width);
  return dimensions == 3 ? sides.prod() : sides.y() * sides.z();
}

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
  // Outliers are uniform in a box, normally one along the principal axes. Where the
  // points spread equally in every direction, these axes are arbitrary, and a box along
  // them is up to twice as large: with the smaller of the two, curves through outliers
  // gain least.
  const double width = least_width * frame.diagonal;
  frame.volume = volumeOf(extent, width, frame.dimensions);
  Point along_axes = high - low;
  std::sort(along_axes.data(), along_axes.data() + 3);
  const bool arbitrary = eigen.eigenvalues().y() > alike * eigen.eigenvalues().z();
  if (arbitrary && (frame.dimensions == 3 || along_axes.x() <= thin))
    frame.volume =
        std::min(frame.volume, volumeOf(along_axes, width, frame.dimensions));
  return frame;
}

} // namespace linelet
