// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <linelet/screen/glyph_image.h>
#include <linelet/screen/tensor_glyph.h>
#include <linelet/support/camera.h>
#include <linelet/support/visibility.h>
#include <linelet/tensor/shape_factors.h>

namespace LINELET_PUBLIC linelet {

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
 * glyphs does not matter. Glyphs with any value that is not finite are left out. */
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
