// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <string_view>

#include <linelet/support/names.h>
#include <linelet/support/points.h>
#include <linelet/support/visibility.h>
#include <linelet/tensor/weighting.h>

namespace LINELET_PUBLIC linelet {

/** \brief The reference point of a neighborhood tensor. */
enum class Centroid {
  QueryPoint,    ///< the query point itself: the point distribution tensor
  Mean,          ///< of the neighbors
  WeightedMean,  ///< weighted by the distance from the query point
  Median,        ///< geometric median: the least sum of distances
  WeightedMedian ///< geometric median that downweights distant neighbors
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
 * Pass coordinates relative to the query point (which is then zero) to keep full
 * precision far from the origin.
 *
 * The medians start at the mean and take Weiszfeld steps, corrected after Vardi and
 * Zhang (2000) where an iterate hits a neighbor, and Newton steps where Weiszfeld's
 * creep, as they do along a wire. The weights w(|p_i - x| / radius) of the weighted
 * median are those at the iterate x. For a weighting that falls with distance this
 * descends to the nearest local minimum of sum_i rho(|p_i - x|) with rho' = w. (The
 * global minimum of sum_i w |p_i - x| lies at infinity for the default weighting, where
 * all weights vanish.)
 *
 * \param[in] type which reference point
 * \param[in] neighbors coordinates of the neighbors, finite
 * \param[in] query the point around which the neighbors were chosen
 * \param[in] radius of the neighborhood, 0 if all neighbors lie at the query point
 * \param[in] weighting w_C, for the weighted types
 * \return the centroid. NaN if there are no neighbors; the mean where all weights of
 * WeightedMean or WeightedMedian are zero */
Point
centroid(Centroid type,
         const Points& neighbors,
         const Point& query,
         double radius,
         const Weighting& weighting = Kernel::QuadraticInverse);

/** \brief Checks that unbounded kernels weigh only distances from the query point: any
 * other place may lie arbitrarily close to a neighbor, whose weight would then depend
 * on rounding.
 * \param[in] weighting of the tensor
 * \param[in] centroid_weighting of the weighted centroids
 * \throws std::invalid_argument naming the weighting and what to use instead */
void
checkWeightings(Centroid centroid,
                const Weighting& weighting,
                const Weighting& centroid_weighting);

/** \brief The geometric median (Centroid::Median), searched from \a start: the same
 * result, sooner if the guess is good. (For an even number of collinear neighbors any
 * point between the middle two is a median.)
 * \return NaN if there are no neighbors */
Point
medianFrom(const Points& neighbors, const Point& start);

} // namespace linelet
