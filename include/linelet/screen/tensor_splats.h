// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <linelet/support/camera.h>
#include <linelet/support/points.h>
#include <linelet/support/visibility.h>
#include <linelet/tensor/eigen_analysis.h>
#include <linelet/tensor/shape_factors.h>

namespace LINELET_PUBLIC linelet {

/** \brief A tensor as it is to be drawn at its point. */
struct TensorGlyph {
  Point center = Point::Zero();
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity(); ///< columns e1, e2, e3
  /// Along these, in the unit of the cloud
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

/** \brief A picture with transparency, row by row: red, green, blue, each times alpha,
 * and alpha. */
struct GlyphImage {
  int width = 0, height = 0;
  std::vector<std::array<float, 4>> pixels;

  std::array<float, 4>&
  at(int x, int y)
  {
    return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)];
  }
  const std::array<float, 4>&
  at(int x, int y) const
  {
    return const_cast<GlyphImage*>(this)->at(x, y);
  }
};

/** \brief How tensor splats look. */
struct SplatSettings {
  double fade = 3;      ///< alpha is (1 - sphericity) to this power
  double stripes = 1.5; ///< periods of the Gabor function from the center to the border
  /// Least half width of a splat, as a fraction of its half length
  double narrowest = 0.25;
  unsigned threads = 0; ///< 0: all; the picture is the same for any number
};

/** \brief Alpha at the center of a splat. */
double
opacity(const ShapeFactors& shape, const SplatSettings& settings);

/** \brief Tensor splats (Ritter & Benger 2012): a disc in the plane of e3 and e2, as
 * long as these axes are, which fades out toward its border. Linear tensors carry
 * stripes along e3 (a Gabor function), planar ones none; the more spherical, the more
 * transparent. Discs are blended from back to front, exactly, so that the order of the
 * glyphs does not matter. Glyphs with anything that is not finite are left out. */
GlyphImage
drawSplats(const std::vector<TensorGlyph>& glyphs,
           const Camera& camera,
           const SplatSettings& settings = {});

/** \brief The ellipsoids of the tensors, opaque and lit from beside the eye; where they
 * overlap, the nearest surface is visible. */
GlyphImage
drawEllipsoids(const std::vector<TensorGlyph>& glyphs,
               const Camera& camera,
               unsigned threads = 0);

} // namespace linelet
