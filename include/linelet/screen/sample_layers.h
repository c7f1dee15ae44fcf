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
 * positions in space; or the points of an organized cloud, a sample each.
 *
 * The samples of a layer are those of all pixels row by row: sample (layer * height +
 * row) * width + column. */
struct SampleLayers {
  static constexpr Index nothing = std::numeric_limits<Index>::max();

  int width = 0, height = 0, layers = 1;
  Point origin = Point::Zero(); ///< what positions are relative to, so that floats do
  std::vector<float> x, y, z;   ///< NaN where nothing is seen
  Indices point;                ///< what is seen: number of a point, or \ref nothing

  std::size_t
  at(int column, int row, int layer = 0) const
  {
    return (static_cast<std::size_t>(layer) * static_cast<std::size_t>(height) +
            static_cast<std::size_t>(row)) *
               static_cast<std::size_t>(width) +
           static_cast<std::size_t>(column);
  }
};

/** \brief Draws points as discs that face the eye into depth buffers, several to a
 * pixel: what pass one of Schiffner et al. 2013 leaves in a multi-sample buffer.
 * \param[in] point_size diameter of the discs, pixels
 * \param[in] diameter the same in units of the cloud, nearer discs look larger; 0: none
 * \param[in] layers samples per pixel: 1, 2, 4 or 8, at the places usual for
 * multi-sampling
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
