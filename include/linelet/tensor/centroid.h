// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <string_view>

#include <linelet/support/names.h>
#include <linelet/support/points.h>
#include <linelet/tensor/weighting.h>

namespace linelet {

/** \brief The point of reference of a neighborhood tensor. */
enum class Centroid {
  QueryPoint,    ///< the query point itself: the point distribution tensor
  Mean,          ///< of the neighbors
  WeightedMean,  ///< weighted by the distance from the query point
  Median,        ///< geometric median: the least sum of distances
  WeightedMedian ///< geometric median that far neighbors take less part in
};

template <>
struct Names<Centroid> {
  static constexpr std::string_view kind = "centroid";
  static constexpr std::array<std::pair<Centroid, std::string_view>, 5> table = {{
      {Centroid::QueryPoint, "pdt"},
      {Centroid::Mean, "mean"},
      {Centroid::WeightedMean, "weighted-mean"},
      {Centroid::Median, "median"},
      {Centroid::WeightedMedian, "weighted-median"},
  }};
};

/** \brief The centroid of a neighborhood.
 *
 * Best called with coordinates relative to the query point (which is then zero): that
 * is what keeps the last digits of a cloud far from the origin.
 *
 * The medians are found from the mean on by Weiszfeld's steps with the treatment of
 * iterates that hit a neighbor of Vardi and Zhang (2000), helped by Newton's steps
 * where the former creep, as they do along a wire. For the weighted median the weights
 * w(|p_i - x| / radius) are those at the iterate x. For a weighting that falls with
 * distance this descends, step by step, to the nearest local minimum of sum_i rho(|p_i
 * - x|) with rho' = w: the global minimum of sum_i w |p_i - x| itself would lie at
 * infinity for the default weighting, where all weights vanish.
 *
 * \param[in] type which point of reference
 * \param[in] neighbors coordinates of the neighbors, finite
 * \param[in] query the point around which the neighbors were chosen
 * \param[in] radius of the neighborhood, 0 where all neighbors lie at the query point
 * \param[in] weighting w_C, for the weighted types
 * \return the centroid. NaN if there are no neighbors; the mean where all weights of
 * WeightedMean or WeightedMedian are zero */
Point
centroid(Centroid type,
         const Points& neighbors,
         const Point& query,
         double radius,
         const Weighting& weighting = Kernel::QuadraticInverse);

/** \brief The geometric median, Centroid::Median, sought from \a start on: the same
 * place, sooner found where it is guessed well. (Where all neighbors lie on one line
 * and are even in number, any place between the middle two is a median.)
 * \return NaN if there are no neighbors */
Point
medianFrom(const Points& neighbors, const Point& start);

} // namespace linelet
