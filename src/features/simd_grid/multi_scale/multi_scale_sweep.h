// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <vector>

#include <features/scale_sweep.h>
#include <linelet/features/multi_scale_settings.h>
#include <linelet/support/progress_monitor.h>

#include "features/simd_grid/kernels/multi_scale_kernels.h"
#include "features/simd_grid/kernels/weight_error.h"
#include "features/simd_grid/order/block_order.h"
#include "features/simd_grid/order/point_groups.h"
#include "features/simd_grid/single_scale/region.h"
#include "features/simd_grid/single_scale/sweep_method.h"

namespace linelet::grid {

/** \brief Half a unit in the last place of a float. */
constexpr double float_rounding = 0x1p-24;

/** \brief Lists leave out, or sum up, only what is certain by more than this margin for
 * rounding. */
constexpr double margin = 1e-5;

/** \brief The shapes of the neighborhoods of some queries at all scales. Arrays have
 * an entry per scale. */
struct LeafShapes {
  std::size_t count = 0; ///< queries
  std::array<Index, leaf_queries> query{};
  std::array<std::uint32_t, leaf_queries> here{}; ///< points in the place of each query
  std::vector<Lanes<std::uint32_t>> neighbors;
  /// NaN where a scale is not defined.
  std::vector<Lanes<float>> linearity, planarity, sphericity;
  /// xx xy xz yy yz zz, in units of MultiScaleJob::unit squared.
  std::vector<std::array<Lanes<double>, 6>> tensors;

  explicit LeafShapes(std::size_t scales)
      : neighbors(scales),
        linearity(scales),
        planarity(scales),
        sphericity(scales),
        tensors(scales)
  {
  }
};

/** \brief Takes the shapes of a leaf; they are valid during the call. */
using LeafVisitor = std::function<void(const LeafShapes&)>;

/** \brief Input of the sweep over all blocks. */
struct MultiScaleJob {
  const BlockFrame& frame; ///< edge at least the largest radius
  const BlockOrder& surface;
  const PointGroups& groups; ///< of the surface
  const BlockOrder& queries; ///< may be the same as the surface
  const MultiScaleSettings& settings;
  const std::vector<double>& radii; ///< ascending
  double unit; ///< of lengths: the largest radius, or less where no two points are as
               ///< far apart, and nothing is searched beyond it
  const ProgressMonitor* monitor; ///< may be null
  std::atomic<bool>& stop;        ///< once true, computation stops
};

/** \brief Queries of one block: sorted indices begin to end of their BlockOrder, a part
 * that it has cut. */
struct MultiScalePiece {
  std::size_t block, begin, end;
};

/** \brief Shapes at all radii of the queries of a piece; one per thread.
 *
 * The queries are split into parts, down to leaves of 16 queries that lie together, one
 * per lane of a vector of floats. What a part can reach is tracked by the groups of
 * points that PointGroups makes; only a leaf processes single points.
 *
 * For const weights around the query or the mean, every scale has its own groups:
 * groups whose points are neighbors of all queries of a part are summed once and leave
 * the list; the rest is the surface of the ball, opened by the leaf and processed pair
 * by pair. For other weights a leaf has one list of candidates for all scales, in the
 * order of the smallest scale that can reach them: the neighborhood of every scale is
 * at the head of the list, and distances serve all scales.
 *
 * Float coordinates are relative to the leaf, made from double for the smaller scales.
 * As in \ref BlockSweep, pairs within rounding of a radius are decided in double, and a
 * query with a scale whose float sums may be off by more than shape factors allow is
 * computed again in double up to that scale. */
class MultiScaleSweep {
public:
  MultiScaleSweep(const MultiScaleJob& job, LeafVisitor visit);

  void
  operator()(const MultiScalePiece& piece);

private:
  /** \brief Part of the queries of the block, and the ball around them. */
  struct Part {
    std::size_t begin, end;
    Point center; // relative to the block
    double size;  // distance of the farthest query from the center
  };

  Part
  part(std::size_t begin, std::size_t end) const;

  /** \brief Groups that a part can reach, one entry per reach. */
  struct Level {
    std::vector<PointList> open;
    std::vector<Moments> inside; // of groups that left, about the block's center
  };

  /** \brief Fills the region for queries of a block. */
  void
  gather(std::size_t block);

  void
  addGroup(const PointGroup& group);

  /** \brief Computes the shapes of some queries.
   * \param[in] depth level of the part that they are in, plus one */
  void
  refine(std::size_t begin, std::size_t end, std::size_t depth, int cuts_left);

  /** \brief Makes the level of a part from that of the part it belongs to. */
  void
  shrink(const Part& queries, std::size_t depth);

  /** \brief Opens groups, see MultiScaleKernels. */
  void
  open(const Part& queries,
       const PointList& groups,
       float near,
       float far,
       PointList& list,
       Moments& certain);

  void
  setScales(const Part& queries, const Level& level);

  void
  solve(const Part& queries, const Level& level);

  void
  countHere(const Part& queries);

  void
  sums(const Part& queries, const Level& level);

  void
  weights(const Part& queries);

  void
  centered(const Part& queries);

  /** \brief Settles the pairs that rounding leaves undecided: those in \ref doubts_
   * that are neighbors get the weight of their distance. */
  void
  settle(const Part& queries, const Weighting& weighting, std::vector<ScaleSums>& sums);

  static void
  add(double weight, const Point& v, std::size_t lane, ScaleSums& sums);

  /** \brief From sums to tensors and factors, at one scale. */
  void
  finish(const Part& queries,
         std::size_t scale,
         const ScaleSums& sums,
         const Moments* inside,
         Reference reference,
         bool relative);

  /** \brief Computes the first \a scales of a query again. */
  void
  inDouble(std::size_t begin, std::size_t lane, std::size_t scales);

  double
  coordinateError(std::size_t scale, double size) const;

  const MultiScaleJob& job_;
  MultiScaleKernels kernels_;
  BlocksAround around_;
  LeafVisitor visit_;
  SweepMethod method_;
  SweepWeight weight_, center_weight_;
  WeightError weight_error_;
  std::vector<double> radii_;    // of the weights, in units
  std::vector<double> searched_; // the same, at most 1

  // Distances from queries up to which groups are listed: none, for what lies in the
  // place of a query, then the radii, or the largest alone where one list serves all.
  std::vector<double> reaches_;

  // Groups around the block at hand: the balls around them, their points, and sums over
  // these about the block's center.
  std::size_t block_;
  Point origin_;       // center of the block
  double reach_ = 0.5; // largest coordinate of a query
  PointList region_;
  GroupPlaces places_;
  std::vector<Moments> group_sums_;
  std::vector<std::uint32_t> certain_;

  std::size_t first_ = 0;      // sorted index of the first query of the piece
  std::vector<Point> queries_; // relative to the block, in units of the largest radius
  std::deque<Level> levels_;   // one per depth of refinement

  std::vector<LeafScale> scales_; // seen from the leaf at hand
  PointList leaf_, core_, spare_; // core: near enough to be in the place of a query
  std::vector<std::size_t> ends_;

  LeafQueries at_;                        // relative to the leaf
  std::array<Lanes<double>, 3> exact_at_; // the same in double
  std::vector<ScaleSums> sums_, center_sums_;
  std::vector<Doubt> doubts_;
  std::array<std::size_t, leaf_queries> redo_{}; // scales of each query to do again
  LeafShapes shapes_;
  ScaleSweep sweep_;
};

} // namespace linelet::grid
