// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <atomic>
#include <deque>
#include <optional>
#include <vector>

#include <linelet/features/tensor_record.h>
#include <linelet/features/tensor_settings.h>
#include <linelet/support/progress_monitor.h>

#include "features/simd_grid/kernels/quadratic_moments.h"
#include "features/simd_grid/kernels/sweep_kernels.h"
#include "features/simd_grid/order/block_order.h"
#include "region.h"
#include "sweep_method.h"

namespace linelet::grid {

/** \brief Input of the sweep over all blocks. */
struct SweepJob {
  const BlockFrame& frame; ///< edge at least the radius
  const BlockOrder& surface;
  const BlockOrder& queries; ///< may be the same
  const TensorSettings& settings;
  const SweepWeight& weight;
  double radius; ///< within which is searched: of all queries, or the largest of
  double reach;  ///< no two points are farther apart: larger radii search no farther
  const std::vector<double>* radii; ///< one per query of the input, or null
  PointDistributionTensor* records; ///< one per query of the input
  const ProgressMonitor* monitor;   ///< may be null
  std::atomic<bool>& stop;          ///< once true, computation stops
};

/** \brief Computes the records of all queries of a block; one per thread.
 *
 * The queries of a block are split into parts as BlockOrder has cut them, and these
 * again, down to a few queries; for each part the list of candidates shrinks to what
 * its ball of queries can reach. For the const weighting, points that all queries of a
 * part have as neighbors are summed once and leave the list: what remains is the
 * surface of the ball, not its volume. The same is done, with higher moments, for
 * weights that are polynomials of the squared distance.
 *
 * Coordinates of a list are float, relative to the block or, in the last step, to the
 * part, in units of the radius. Pairs whose distance is within rounding of the radius
 * are decided in double; a tensor that is too small for float (see \ref
 * SweepKernels::records) is computed again in double, as Engine::Tree would. */
class BlockSweep {
public:
  explicit BlockSweep(const SweepJob& job);

  void
  operator()(std::size_t block);

private:
  /** \brief Part of the queries of the block, and the ball around them. */
  struct Part {
    std::size_t begin, end;
    Point center;             // relative to the block
    double size;              // distance of the farthest query from the center
    double shortest, longest; // radii that are searched
    double widest;            // radius of the weights
  };

  Part
  part(std::size_t begin, std::size_t end) const;

  void
  refine(const Part& queries,
         const PointList& list,
         const QuadraticMoments& inside,
         std::size_t depth);

  /** \brief Refines the parts into which cutting the queries makes them. */
  void
  refineParts(std::size_t begin,
              std::size_t end,
              int cuts_left,
              const PointList& list,
              const QuadraticMoments& inside,
              std::size_t depth);

  /** \brief Sums for the queries of a leaf from the last list.
   * \param[in] inside of points that left the lists, relative to the block */
  void
  solve(const Part& queries, const QuadraticMoments& inside);
  void
  sumConst(const Part& queries, const Moments& inside);
  void
  sumWeighted(const Part& queries, std::size_t query, const QuadraticMoments& inside);
  void
  sumCentered(const Part& queries, std::size_t query);

  /** \brief Keeps the sums of a query for its record.
   * \param[in] at the query in the coordinates of the sums */
  void
  keep(std::size_t query, const Moments& sums, const Point& at, double neighbors);

  /** \brief Whether to stop; asks the monitor. */
  bool
  stopped() const;

  /** \brief In the unit of the input, not of the lists. */
  double
  radiusOf(std::size_t query) const;
  double
  searchedRadiusOf(std::size_t query) const;
  double
  squaredDistance(std::size_t query, std::uint32_t sorted_index) const;
  bool
  isNeighbor(std::size_t query, std::uint32_t sorted_index) const;

  /** \brief Places in the last list of the points in the band that are neighbors. */
  const Indices&
  decide(std::size_t query, const BandedQuery& around);

  /** \brief In the coordinates of the last list. */
  BandedQuery
  banded(const Part& queries, std::size_t query) const;

  PointDistributionTensor
  inDouble(std::size_t query, const PointList& candidates);

  void
  write();

  const SweepJob& job_;
  SweepKernels kernels_;
  RegionGatherer gather_;
  SweepMethod method_;
  std::optional<QuadraticWeight> quadratic_; // for SweepMethod::Weights

  std::size_t first_ = 0;      // sorted index of the first query of the block
  Point origin_;               // center of the block
  double reach_ = 1;           // largest coordinate of a list
  std::vector<Point> queries_; // relative to the block, in units of the radius
  std::vector<double> radii_;  // searched, in the same unit
  std::vector<double> widths_; // of the weights
  std::array<std::vector<double>, 10> sums_;  // of every query of the block
  std::array<std::vector<double>, 3> places_; // of the query, as its sums see it
  std::vector<double> found_;

  PointList region_;             // what any query of the block can reach
  std::deque<PointList> levels_; // one per depth of refinement
  PointList certain_; // neighbors of all queries of a part, for SweepMethod::Weights
  PointList last_, dense_;
  Indices doubtful_;
  Points offsets_;
};

} // namespace linelet::grid
