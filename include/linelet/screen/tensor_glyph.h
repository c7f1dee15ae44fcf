// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>

#include <Eigen/Core>

#include <linelet/support/points.h>
#include <linelet/support/visibility.h>
#include <linelet/tensor/eigen_analysis.h>
#include <linelet/tensor/shape_factors.h>

namespace LINELET_PUBLIC linelet {

/** \brief A tensor to be drawn at its point. */
struct TensorGlyph {
  Point center = Point::Zero();
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity(); ///< columns e1, e2, e3
  /// Along these axes, in the unit of the cloud
  Eigen::Vector3d half_lengths = Eigen::Vector3d::Ones();
  ShapeFactors shape{};
  std::array<float, 3> color{}; ///< red, green, blue in [0, 1]
};

/** \brief The glyph of a tensor whose longest half axis is \a size; the half axes are
 * proportional to the square roots of the eigenvalues.
 * \param[in] colors of linearity, planarity and sphericity, mixed by the factors */
TensorGlyph
glyphOf(const Point& center,
        const EigenSystem& system,
        const ShapeFactors& shape,
        double size,
        const std::array<std::array<double, 3>, 3>& colors);

} // namespace linelet
