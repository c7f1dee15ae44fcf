// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <linelet/tensor/weighting.h>

#include "features/simd_grid/order/point_list.h"
#include "quadratic_moments.h"
#include "weight_error.h"
#include "weight_table.h"

namespace linelet::grid {

using Float3 = std::array<float, 3>;

/** \brief Squared radii between which rounding may decide: below \a low a point is a
 * neighbor, above \a high it is not, and in between the distance in double decides. */
struct Band {
  float low, high;
};

/** \brief A query in the coordinates of a list, and the band of its radius. */
struct BandedQuery {
  Float3 at;
  Band band;
};

/** \brief A part of a BlockOrder, to be seen from \a origin in units of 1/\a scale. */
struct Run {
  const double* x;
  const double* y;
  const double* z;
  std::size_t begin, end;
  std::array<double, 3> origin;
  double scale;
};

/** \brief A box around query points, from low to high. */
struct Box {
  Float3 low, high;
};

/** \brief A ball around query points. */
struct Ball {
  Float3 center;
  float inside;  ///< squared distance from the center up to which a point is certainly
                 ///< a neighbor of all of them; negative: none is
  float outside; ///< and beyond which it is of none
  /// Squared distance up to which weights may differ from \ref WeightTable
  float near = 0;
};

/** \brief Candidates for the neighbors of a query, with the query in the coordinates
 * of each list. */
struct WeightedLists {
  const PointList& doubtful;
  BandedQuery query;
  const PointList& certain; ///< neighbors, and none of them near; may lack padding
  Float3 certain_query;
};

/** \brief Sums over the neighbors of many queries: arrays with an entry per query, and
 * room for \ref PointList::padding more. */
struct QuerySums {
  std::size_t count;
  std::array<const double*, 10> moments; ///< weight x y z xx xy xz yy yz zz
  std::array<const double*, 3> query;    ///< in the coordinates of the sums
  const double* found;                   ///< number of neighbors
};

/** \brief How sums become records. */
struct RecordSettings {
  bool mean; ///< tensors are about the mean of the neighbors, not the query
  WeightError weight_error;
  double coordinate_error; ///< rounding of a coordinate, in its unit
  double area;             ///< that unit, squared
  bool by_count;           ///< tensors are divided by the number of neighbors
};

/** \brief Records of some queries: the floats of PointDistributionTensor in its order,
 * one array each. */
struct RecordLanes {
  static constexpr std::size_t queries = 16;
  std::array<std::array<float, queries>, 18> entry;
};

/** \brief How many points lie in a ball for certain, and whether any do in its band. */
struct Found {
  std::size_t certain;
  bool doubtful;
};

/** \brief Eigen-analysis of many tensors: entries one after the other, each of \a count
 * lanes; arrays have room for \ref PointList::padding more. */
struct EigenBatch {
  std::size_t count;
  std::array<const double*, 6> tensor; ///< xx xy xz yy yz zz
  std::array<double*, 3> values;       ///< ascending, not negative
  std::array<double*, 3> major;        ///< e3
  std::array<double*, 3> normal;       ///< e1
};

/** \brief The inner loops, compiled for every instruction set. Lists are padded on the
 * way in and out. */
struct SweepKernels {
  const char* target; ///< name of the instruction set
  std::size_t lanes;  ///< floats in a vector

  /** \brief Appends the points of \a run within distance \a reach (squared) of \a box;
   * coordinates relative to the run's origin. Does not pad. */
  void (*gather)(const Run& run, const Box& box, float reach, PointList& list);

  /** \brief The points of \a in that are not certainly outside; those certainly inside
   * are added to \a inside instead, if that is given, with coordinates relative to the
   * ball's center. \a recenter: so are those of \a out, whose h is then set. */
  void (*classify)(const PointList& in,
                   const Ball& ball,
                   bool recenter,
                   PointList& out,
                   Moments* inside);

  /** \brief As \ref classify, but the points certainly inside and not near are appended
   * to \a certain, as they are in \a in, without h and id and without padding. Nor does
   * \a out get an h. */
  void (*split)(const PointList& in,
                const Ball& ball,
                bool recenter,
                PointList& out,
                PointList& certain);

  /** \brief Adds to the sums of each query the moments of the points of a recentered
   * list within its ball; points of the band are left out.
   * \return which of the queries, at most 32, have points in the band, one bit each */
  std::uint32_t (*constSums)(const PointList& list,
                             const BandedQuery* queries,
                             std::size_t count,
                             Moments* sums);

  /** \brief Weighted moments relative to a query of its neighbors, by a kernel; the
   * weight's argument is squared distance times \a scale. Points of the band are left
   * out. The first moments are not summed. */
  Found (*weightedSums)(const WeightedLists& lists,
                        const SweepWeight& weight,
                        float scale,
                        Moments& sums);

  /** \brief Adds the sums of the points of \a list from \a begin on, relative to \a
   * center. */
  void (*quadraticMoments)(const PointList& list,
                           std::size_t begin,
                           const Float3& center,
                           QuadraticMoments& sums);

  /** \brief Weighted moments relative to \a center of all points of \a list. */
  void (*momentsAround)(const PointList& list,
                        const Float3& center,
                        const Weighting& weighting,
                        float scale,
                        Moments& sums);

  /** \brief The points of \a list within the ball around \a query, relative to it,
   * those of the band left out.
   * \return whether there are any */
  bool (*neighbors)(const PointList& list, const BandedQuery& query, PointList& out);

  /** \brief Places in \a list of the points in the band around \a query.
   * \param[in] constant_weights as \ref constSums sees them, else as the others do */
  void (*inBand)(const PointList& list,
                 const BandedQuery& query,
                 bool constant_weights,
                 Indices& places);

  /** \brief w(sqrt(u)) for \a count values of u, a multiple of \ref lanes. With \a
   * table: as \ref weightedSums has them, for u below 1. */
  void (*weights)(const SweepWeight& weight,
                  bool table,
                  const float* squared,
                  float* values,
                  std::size_t count);

  /** \brief Records of \ref RecordLanes::queries queries from \a first on.
   * \return those whose float sums give shape factors to 1e-4, one bit each */
  std::uint32_t (*records)(const QuerySums& sums,
                           const RecordSettings& settings,
                           std::size_t first,
                           RecordLanes& out);

  /** \brief Eigenvalues and the outer eigenvectors. */
  void (*eigen)(const EigenBatch& batch);
};

/** \brief The inner loops for the best instruction set of this machine. */
SweepKernels
sweepKernels();

} // namespace linelet::grid
