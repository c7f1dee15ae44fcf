// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>

#include "block_order.h"
#include "sweep_kernels.h"

namespace linelet::grid {

inline Float3
toFloat(const Point& p)
{
  return {
      static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())};
}

/** \brief Gathers what the queries of a block can reach; one a thread. */
class RegionGatherer {
public:
  /** \param[in] frame edge at least the radius of the queries
   * \param[in] unit of the coordinates of a region, their largest radius */
  RegionGatherer(const BlockFrame& frame, const BlockOrder& surface, double unit)
      : frame_(frame), surface_(surface), gather_(sweepKernels().gather), unit_(unit)
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
  const BlockFrame& frame_;
  const BlockOrder& surface_;
  decltype(SweepKernels::gather) gather_;
  double unit_;
  std::array<std::size_t, 9> cursors_{}; // where the last block's runs began
};

} // namespace linelet::grid
