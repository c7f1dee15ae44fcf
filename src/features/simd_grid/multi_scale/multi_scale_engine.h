// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>
#include <memory>
#include <vector>

#include <linelet/features/cloud_piece.h>
#include <linelet/support/progress_monitor.h>

#include "features/simd_grid/order/block_order.h"
#include "multi_scale_sweep.h"

namespace linelet::grid {

/** \brief A set of points, sorted for shapes of neighborhoods up to a largest radius.
 */
class MultiScaleEngine {
public:
  /** \param[in] surface kept by reference
   * \param[in] queries whose shapes will be requested
   * \param[in] largest_radius of all that will be requested
   * \param[in] piece of the surface that alone is visited, with some points around it;
   * null: all queries are */
  MultiScaleEngine(const Points& surface,
                   const Points& queries,
                   double largest_radius,
                   int threads,
                   const CloudPiece* piece = nullptr);

  /** \brief Unit of length of LeafShapes; tensors are in its square. */
  double
  unit() const
  {
    return unit_;
  }

  /** \brief Whether the points could be sorted; false if the radius is so small for
   * their extent that blocks cannot be numbered. */
  bool
  usable() const
  {
    return surface_order_ != nullptr;
  }

  /** \brief Visits the shapes of all queries that are finite and near the surface; the
   * others have no neighbors. In the order of their places in space, the same for any
   * number of threads.
   * \param[in] chosen ascending indices of the queries to visit, or null for all
   * \param[in] radii ascending
   * \param[in] make_visitor called once by every thread
   * \throws Canceled */
  void
  run(const Points& queries,
      const Indices* chosen,
      const std::vector<double>& radii,
      const MultiScaleSettings& settings,
      const std::function<LeafVisitor()>& make_visitor,
      ProgressMonitor* monitor) const;

private:
  bool
  isWanted(const BlockOrder& order, const MultiScalePiece& part) const;

  const Points& surface_;
  const CloudPiece* piece_;
  double unit_ = 0;
  int threads_;
  std::unique_ptr<BlockFrame> frame_;
  std::unique_ptr<BlockOrder> surface_order_;
  std::unique_ptr<PointGroups> groups_; // of these
};

/** \brief How far around a piece its points must be known: two blocks. */
double
multiScaleGridMargin(double largest_radius);

} // namespace linelet::grid
