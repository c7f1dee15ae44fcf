// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/tensor/centroid.h>

#include <limits>
#include <stdexcept>
#include <string>

#include "geometric_median.h"

namespace linelet {

namespace {

Point
mean(const Points& points)
{
  const double count = static_cast<double>(points.size());
  Point sum = Point::Zero();
  for (const Point& point : points)
    sum += point;
  const Point rough = sum / count;
  // Remove the rounding error, so that the mean of coincident points is their position.
  sum.setZero();
  for (const Point& point : points)
    sum += point - rough;
  return rough + sum / count;
}

Point
weightedMean(const Points& points,
             const Point& query,
             double inverse_radius,
             const Weighting& weighting)
{
  Point sum = Point::Zero();
  double total = 0;
  for (const Point& point : points) {
    const Point offset = point - query;
    const double weight = weighting(offset.norm() * inverse_radius);
    sum += weight * offset;
    total += weight;
  }
  if (!(total > 0))
    return mean(points);
  return query + sum / total;
}

} // namespace

Point
centroid(Centroid type,
         const Points& neighbors,
         const Point& query,
         double radius,
         const Weighting& weighting)
{
  if (neighbors.empty())
    return Point::Constant(std::numeric_limits<double>::quiet_NaN());
  const double inverse_radius = radius > 0 ? 1 / radius : 0;
  switch (type) {
  case Centroid::Mean:
    return mean(neighbors);
  case Centroid::WeightedMean:
    return weightedMean(neighbors, query, inverse_radius, weighting);
  case Centroid::Median:
    return geometricMedian(neighbors, mean(neighbors), 0, nullptr);
  case Centroid::WeightedMedian:
    return geometricMedian(neighbors, mean(neighbors), inverse_radius, &weighting);
  case Centroid::QueryPoint:
    break;
  }
  return query;
}

Point
medianFrom(const Points& neighbors, const Point& start)
{
  if (neighbors.empty())
    return Point::Constant(std::numeric_limits<double>::quiet_NaN());
  return geometricMedian(neighbors, start, 0, nullptr);
}

void
checkWeightings(Centroid centroid,
                const Weighting& weighting,
                const Weighting& centroid_weighting)
{
  if (centroid != Centroid::QueryPoint && isUnbounded(weighting.kernel()))
    throw std::invalid_argument("weighting " + weighting.name() +
                                " is unbounded at the centroid, which may lie at any "
                                "distance from a neighbor; use it with centroid " +
                                std::string(nameOf(Centroid::QueryPoint)));
  if (centroid == Centroid::WeightedMedian && isUnbounded(centroid_weighting.kernel()))
    throw std::invalid_argument(
        "a weighted median cannot use an unbounded weighting such as " +
        centroid_weighting.name() + "; use quadratic-inverse");
}

} // namespace linelet
