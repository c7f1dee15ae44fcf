// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>

#include <linelet/screen/screen_normal_settings.h>

#include "support/uninitialized.h"

namespace linelet::screen {

/** \brief Samples with a margin of NaN about every layer, wide enough for the largest
 * pattern and for whole vectors. */
struct PaddedSamples {
  static constexpr int margin = 3;

  int width = 0, height = 0, layers = 0;
  std::ptrdiff_t stride = 0; ///< from row to row
  std::ptrdiff_t layer = 0;  ///< from layer to layer
  UninitializedVector<float> x, y, z;
  UninitializedVector<float> cx, cy, cz; ///< every pixel's own position

  std::ptrdiff_t
  at(int column, int row) const
  {
    return (row + margin) * stride + column + margin;
  }
};

/** \brief Pixels processed at a time. */
constexpr int block = 64;

/** \brief Rings of four pixels counterclockwise, the first in the order of patterns.
 */
constexpr int ring_places[6][4][2] = {{{1, 1}, {-1, 1}, {-1, -1}, {1, -1}},
                                      {{2, 2}, {-2, 2}, {-2, -2}, {2, -2}},
                                      {{2, 0}, {0, 2}, {-2, 0}, {0, -2}},
                                      {{3, 3}, {-3, 3}, {-3, -3}, {3, -3}},
                                      {{1, 0}, {0, 1}, {-1, 0}, {0, -1}},
                                      {{3, 0}, {0, 3}, {-3, 0}, {0, -3}}};

/** \brief Rings of a pattern of \a samples pixels. */
constexpr int
ringsOf(unsigned samples)
{
  return static_cast<int>(samples - 1) / 4;
}

/** \brief Normals, not yet turned toward the eye, of \ref block pixels from \a column
 * on; NaN where there are none. */
struct NormalBlock {
  float x[block], y[block], z[block];
};

/** \brief Normals in the places of PaddedSamples::cx, NaN around them. */
struct PaddedNormals {
  UninitializedVector<float> x, y, z;
};

struct NormalKernels {
  /// Finds the own positions of the pixels of one block: the mean of the samples that
  /// are within \a limit, a square, of the first one.
  void (*positions)(PaddedSamples& samples, float limit, int column, int row);

  /// Of one block, by the method of the settings.
  void (*normals)(const PaddedSamples& samples,
                  const ScreenNormalSettings& settings,
                  int column,
                  int row,
                  NormalBlock& out);

  /// Smooths one block, see \ref smoothed.
  void (*smooth)(const PaddedSamples& samples,
                 const PaddedNormals& normals,
                 float limit,
                 int column,
                 int row,
                 PaddedNormals& out);
};

/** \brief The kernels for this processor. */
NormalKernels
normalKernels();

} // namespace linelet::screen
