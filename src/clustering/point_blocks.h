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

/** \brief Locates points block by block, on vectors where the cells are boxes. */
class BlockLocator {
public:
  /** \param[in] border see \ref nearestFace; 0: faces are not asked for */
  BlockLocator(const CellFrame& frame, double border)
      : frame_(frame), border_(border), kernels_(boxKernels())
  {
  }

  void
  locate(const Point* points, int count, PointBlock& block) const
  {
    if (frame_.perspective)
      locatePieces(points, count, block);
    else if (border_ > 0)
      kernels_.locateWithFaces(frame_, border_, points, count, block);
    else
      kernels_.locate(frame_, points, count, block);
  }

  /** \brief The cell of a number in PointBlock::cell. */
  Cell
  cellOf(double number) const
  {
    const auto all = static_cast<std::uint64_t>(number);
    const auto row = static_cast<std::uint64_t>(frame_.cells[0]);
    const auto column = static_cast<std::uint64_t>(frame_.cells[1]);
    const std::uint64_t rows = all / row;
    return {static_cast<std::int32_t>(all % row),
            static_cast<std::int32_t>(rows % column),
            static_cast<std::int32_t>(rows / column)};
  }

  /** \brief Calls work(block, number of its first point, first of the run, its length)
   * for runs of points in the same cell. */
  template <class Work>
  void
  forRuns(const Points& points,
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
      int first = 0;
      for (int run = 0; run < block.runs; ++run) {
        work(block, begin, first, block.ends[run] - first);
        first = block.ends[run];
      }
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
      block.x[i] = points[i].x();
      block.y[i] = points[i].y();
      block.z[i] = points[i].z();
      block.cell[i] = located
                          ? (static_cast<double>(cell[2]) * frame_.cells[1] + cell[1]) *
                                    frame_.cells[0] +
                                cell[0]
                          : PointBlock::nowhere;
      if (border_ > 0)
        block.face[i] =
            located ? nearestFace(part, border_, steps / border_) : inside_cell;
    }
  }

  const CellFrame& frame_;
  double border_;
  BoxKernels kernels_;
};

} // namespace linelet::clustering
