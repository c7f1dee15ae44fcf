// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "features/simd_grid/order/point_groups.h"
#include "features/simd_grid/order/point_list.h"
#include "sweep_kernels.h"
#include "weight_table.h"

namespace linelet::grid {

/** \brief Queries that are processed together, one per lane of the widest vector. */
constexpr std::size_t leaf_queries = 16;

/** \brief A number for every query of a leaf. */
template <class T>
struct alignas(64) Lanes {
  T lane[leaf_queries] = {};

  T&
  operator[](std::size_t i)
  {
    return lane[i];
  }
  const T&
  operator[](std::size_t i) const
  {
    return lane[i];
  }
};

/** \brief Where the queries of a leaf are, relative to its center. */
struct LeafQueries {
  Lanes<float> x, y, z;
};

/** \brief Places in \ref ScaleSums of the sums over points p. */
enum Moment : std::size_t { Total, X, Y, Z, XX, XY, XZ, YY, YZ, ZZ, moments };

/** \brief Weighted moments of a neighborhood of every query, and its size. */
struct ScaleSums {
  std::array<Lanes<double>, moments> sum;
  Lanes<float> found;
};

/** \brief One scale of a multi-scale sweep, seen from a leaf. Lengths are in units of
 * the largest radius. */
struct LeafScale {
  float radius;
  Band band;     ///< squared
  float near;    ///< squared distance from the center up to which a point is certainly
                 ///< a neighbor of all queries; negative: none is
  float far;     ///< and beyond which it is of none
  bool relative; ///< sums are about each query, not about the center of the leaf: the
                 ///< leaf is wide compared with the radius, and moments would cancel
};

/** \brief A point that rounding leaves undecided for some queries at one scale. */
struct Doubt {
  std::uint32_t place; ///< in its list
  std::uint16_t scale;
  std::uint16_t queries; ///< one bit each
};

/** \brief The points of the groups around a block. */
struct GroupPlaces {
  const BlockOrder& order;
  std::vector<std::uint32_t> begin, size; ///< sorted indices of each group
  /// Relative to the block in units of the largest radius; with room in every group for
  /// the largest, and padding. Without h and id.
  PointList points;
};

/** \brief Where the points of groups are seen from. */
struct GroupView {
  Float3 center; ///< relative to the block in units of the largest radius
  Point origin;  ///< the same place as the points came
  double scale;  ///< from there to these units
  float sharp;   ///< squared distance up to which coordinates are made from double
};

/** \brief What a tensor refers to. */
enum class Reference {
  Query, ///< sums are about the center of the leaf, the tensor about the query
  Mean,  ///< the tensor is about the mean of what was summed
  Sums   ///< what the sums are about already
};

/** \brief Sums of one scale on their way to tensors. */
struct ShapeInput {
  const ScaleSums& sums;
  const Moments* inside; ///< of points that all queries have, about the center, or null
  bool relative;         ///< sums are about the query, not the center
  Reference reference;
  std::array<Lanes<double>, 3> query; ///< relative to the center
  double coordinate_error;
  double weight_absolute, weight_relative; ///< errors; absolute times radius squared
};

/** \brief The inner loops of the multi-scale sweep, compiled for every instruction set.
 */
struct MultiScaleKernels {
  /** \brief Sorts groups, each the ball of \a groups.h around a center, by their
   * distance from \a center.
   * \param[in] near, far balls that are nearer than \a near (none where it is not
   * positive) are certain, what is beyond \a far is left out, and the rest is open
   * \param[out] certain ids of these balls; room for all and a vector more
   * \return number of these balls */
  std::size_t (*splitGroups)(const PointList& groups,
                             const Float3& center,
                             float near,
                             float far,
                             PointList& open,
                             std::uint32_t* certain);

  /** \brief Puts the points of a group into its places, seen from a block. */
  void (*placeGroup)(GroupPlaces& places, std::size_t group, const GroupView& view);

  /** \brief Tests the points of groups. Those nearer to the center than \a near
   * (squared) are added to \a certain, those beyond \a far (squared) are left out, and
   * the rest makes the list \a open, which has room for all. */
  void (*openGroups)(const PointList& groups,
                     const GroupPlaces& places,
                     const GroupView& view,
                     float near,
                     float far,
                     PointList& open,
                     Moments& certain);

  /** \brief Puts a recentered list in the order of the smallest scale that can reach a
   * point.
   * \param[out] ends points that each scale can reach */
  void (*order)(PointList& list,
                PointList& spare,
                const LeafScale* scales,
                std::size_t count,
                std::size_t* ends);

  /** \brief Adds the number of points within \a tolerance (squared) of each query. */
  void (*coincident)(const PointList& list,
                     float tolerance,
                     const LeafQueries& queries,
                     Lanes<float>& counts);

  /** \brief Moments of the neighbors, all with weight 1. */
  void (*constPairs)(const PointList& list,
                     const LeafQueries& queries,
                     const LeafScale& scale,
                     std::uint16_t scale_number,
                     ScaleSums& sums,
                     std::vector<Doubt>& doubts);

  /** \brief Moments of the neighbors at all scales, weighted by the distance from the
   * query.
   * \param[in] first_only no second moments are needed */
  void (*weightedPairs)(const PointList& list,
                        const std::size_t* ends,
                        const LeafQueries& queries,
                        const LeafScale* scales,
                        std::size_t count,
                        const SweepWeight& weight,
                        bool first_only,
                        ScaleSums* sums,
                        std::vector<Doubt>& doubts);

  /** \brief Moments of the neighbors at one scale about \a centers, weighted by the
   * distance from there. */
  void (*centeredPairs)(const PointList& list,
                        std::size_t end,
                        const LeafQueries& queries,
                        const LeafScale& scale,
                        const LeafQueries& centers,
                        const SweepWeight& weight,
                        ScaleSums& sums);

  /** \brief Tensors from sums.
   * \return queries, one bit each, whose float sums give shape factors to 1e-4 */
  std::uint32_t (*finish)(const ShapeInput& work,
                          std::array<Lanes<double>, 6>& tensors,
                          Lanes<float>& found);

  /** \brief Shape factors of tensors. */
  void (*factors)(const std::array<Lanes<double>, 6>& tensors,
                  Lanes<float>& linearity,
                  Lanes<float>& planarity,
                  Lanes<float>& sphericity);
};

/** \brief The inner loops for the best instruction set of this machine. */
MultiScaleKernels
multiScaleKernels();

} // namespace linelet::grid
