// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>
#include <utility>

#include "features/simd_grid/kernels/sweep_kernels.h"
#include "features/simd_grid/order/block_order.h"

namespace linelet::grid {

inline Float3
toFloat(const Point& p)
{
  return {
      static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())};
}

/** \brief Finds the blocks in a cell and next to it; one per thread. */
class BlocksAround {
public:
  /** \brief Blocks that follow each other along x: from the first to before the last.
   */
  using Run = std::pair<std::size_t, std::size_t>;

  BlocksAround(const BlockFrame& frame, const BlockOrder& order)
      : frame_(frame), order_(order)
  {
  }

  /** \brief The blocks that hold points; runs may be empty. */
  std::array<Run, 9>
  operator()(const BlockFrame::Cell& cell);

private:
  const BlockFrame& frame_;
  const BlockOrder& order_;
  std::array<std::size_t, 9> cursors_{}; // where the last cell's runs began
};

/** \brief Gathers the points that the queries of a block can reach; one per thread. */
class RegionGatherer {
public:
  /** \param[in] frame edge at least the radius of the queries
   * \param[in] unit of the coordinates of a region, their largest radius */
  RegionGatherer(const BlockFrame& frame, const BlockOrder& surface, double unit)
      : surface_(surface),
        around_(frame, surface),
        gather_(sweepKernels().gather),
        unit_(unit)
  {
  }

  /** \brief Fills \a region with the points in or beside block \a cell that are within
   * \a reach of the box of \a queries.
   * \param[in] origin of the coordinates of region and queries
   * \param[in] queries at least one, in units
   * \param[in] reach in units */
  void
  operator()(const BlockFrame::Cell& cell,
             const Point& origin,
             const Points& queries,
             double reach,
             PointList& region);

private:
  const BlockOrder& surface_;
  BlocksAround around_;
  decltype(SweepKernels::gather) gather_;
  double unit_;
};

} // namespace linelet::grid
