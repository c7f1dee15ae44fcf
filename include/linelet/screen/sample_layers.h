// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include <linelet/support/camera.h>
#include <linelet/support/points.h>
#include <linelet/support/visibility.h>

namespace LINELET_PUBLIC linelet {

/** \brief What the pixels of a picture see: up to eight samples each, with their
 * positions in space; or the points of an organized cloud, one sample per pixel.
 *
 * A layer holds one sample of every pixel, row by row: sample (layer * height + row) *
 * width + column. */
struct SampleLayers {
  static constexpr Index nothing = std::numeric_limits<Index>::max();

  int width = 0, height = 0, layers = 1;
  Point origin = Point::Zero(); ///< origin of positions, so that float suffices
  std::vector<float> x, y, z;   ///< NaN where nothing is seen
  Indices point;                ///< index of the visible point, or \ref nothing

  std::size_t
  at(int column, int row, int layer = 0) const
  {
    return (static_cast<std::size_t>(layer) * static_cast<std::size_t>(height) +
            static_cast<std::size_t>(row)) *
               static_cast<std::size_t>(width) +
           static_cast<std::size_t>(column);
  }
};

/** \brief Draws points as discs that face the eye into depth buffers with several
 * samples per pixel: the multisample buffer that pass one of Schiffner et al. 2013
 * makes.
 * \param[in] point_size diameter of the discs, pixels
 * \param[in] diameter of the discs in the unit of the cloud, so that nearer ones look
 * larger, but never smaller than \a point_size; 0: \a point_size only
 * \param[in] layers samples per pixel: 1, 2, 4 or 8, at the usual positions of
 * multisampling
 * \param[in] threads 0: all; the result is the same for any number
 * \throws std::invalid_argument */
SampleLayers
sampleLayers(const Points& points,
             const Camera& camera,
             double point_size,
             double diameter = 0,
             int layers = 8,
             unsigned threads = 0);

} // namespace linelet
