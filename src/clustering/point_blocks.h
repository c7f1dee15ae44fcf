// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include <linelet/support/points.h>

#include "box_kernels.h"
#include "nearest_face.h"

namespace linelet::clustering {

/** \brief Locates points block by block, vectorized if the cells are boxes. */
class BlockLocator {
public:
  /** \brief Finds only cells. */
  BlockLocator(const CellDirectory& directory, const CellFrame& frame)
      : BlockLocator(directory, frame, 0, 0)
  {
  }

  /** \param[in] border see \ref nearestFace; 0: faces are not needed
   * \param[in] bits of offsets, in boxes; 0: they are not needed */
  BlockLocator(const CellDirectory& directory,
               const CellFrame& frame,
               double border,
               int bits)
      : directory_(directory),
        frame_(frame),
        border_(border),
        bits_(bits),
        kernels_(boxKernels())
  {
  }

  void
  locate(const Point* points, int count, PointBlock& block) const
  {
    if (frame_.perspective)
      locatePieces(points, count, block);
    else if (border_ > 0)
      kernels_.locateWithFaces(frame_, bits_, border_, points, count, block);
    else if (bits_ > 0)
      kernels_.locateMembers(frame_, bits_, points, count, block);
    else
      kernels_.locate(frame_, points, count, block);
  }

  /** \brief Calls work(block, number of its first point) for blocks of points and
   * their runs of points in the same cell. */
  template <class Work>
  void
  forBlocks(const Points& points,
            std::size_t begin,
            std::size_t end,
            const Work& work) const
  {
    PointBlock block;
    while (begin < end) {
      const auto count = static_cast<int>(
          std::min<std::size_t>(end - begin, std::size_t{PointBlock::size}));
      locate(points.data() + begin, count, block);
      kernels_.findRuns(block);
      work(block, begin);
      begin += static_cast<std::size_t>(count);
    }
  }

private:
  void
  locatePieces(const Point* points, int count, PointBlock& block) const
  {
    block.count = count;
    for (int i = 0; i < count; ++i) {
      Cell cell;
      Point part;
      const bool located = frame_.locate<true>(points[i], cell, part);
      block.key[i] =
          located ? static_cast<double>(directory_.keyOf(cell)) : PointBlock::nowhere;
      if (border_ > 0)
        block.face[i] =
            located ? nearestFace(part, border_, steps / border_) : inside_cell;
    }
  }

  const CellDirectory& directory_;
  const CellFrame& frame_;
  double border_;
  int bits_;
  BoxKernels kernels_;
};

} // namespace linelet::clustering
