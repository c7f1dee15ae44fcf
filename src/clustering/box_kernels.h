// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>

#include <linelet/support/points.h>

#include "cell_frame.h"
#include "point_passes.h"

namespace linelet::clustering {

/** \brief A block of consecutive points, and the cells they are in. */
struct PointBlock {
  static constexpr int size = 256; ///< whose numbers fit into a byte
  static constexpr int margin = 8; ///< so that whole vectors can be read beyond the end
  static constexpr double nowhere = -1;

  int count = 0;
  double key[size + margin];        ///< see CellDirectory::keyOf; or \ref nowhere
  double offset[3][size + margin];  ///< from the middle of the cell, in its integers
  std::int32_t face[size + margin]; ///< see \ref nearestFace
  int runs = 0;
  std::uint8_t starts[size + margin]; ///< of runs of points in one cell
};

/** \brief Corners of a box; inverted infinities if it is empty. */
struct Corners {
  double *low, *high;
};

/** \brief What \ref CellFrame::locate, \ref nearestFace and the sums of members do,
 * vectorized, bit for bit. */
struct BoxKernels {
  /// Widens the corners by the points all of whose coordinates are finite.
  void (*extend)(const Point* points, std::size_t count, const Corners& corners);

  /// Finds the cells of up to PointBlock::size points, and nothing else.
  void (*locate)(const CellFrame& frame, const Point* points, int count, PointBlock&);

  /// The same, and the offsets as integers of the given bits, see \ref CellOrigin.
  void (*locateMembers)(
      const CellFrame& frame, int bits, const Point* points, int count, PointBlock&);

  /// The same, and the nearest faces.
  void (*locateWithFaces)(const CellFrame& frame,
                          int bits,
                          double border,
                          const Point* points,
                          int count,
                          PointBlock&);

  /// Finds the runs of points in one cell.
  void (*findRuns)(PointBlock&);

  /// Adds the points from \a first on to the sums. All partial sums must stay below
  /// 2^53, see \ref exact_bits.
  void (*add)(const PointBlock&, int first, int count, CellSums& sums);
};

/** \brief Offsets of this many bits, see \ref offsetBits, add up exactly in double over
 * a block: 2 (bits + 1) + log2(PointBlock::size) < 53. */
constexpr int exact_bits = 21;

/** \brief The kernels for this processor. */
BoxKernels
boxKernels();

} // namespace linelet::clustering
