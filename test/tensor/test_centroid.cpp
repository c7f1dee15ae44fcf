// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <limits>
#include <string>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <gtest/gtest.h>

#include <linelet/tensor/centroid.h>

using namespace linelet;

namespace {

Points
cluster(std::size_t count, unsigned seed)
{
  boost::random::mt19937 random(seed);
  boost::random::normal_distribution<double> normal;
  Points points;
  for (std::size_t i = 0; i < count; ++i)
    points.emplace_back(normal(random), normal(random), 0.3 * normal(random));
  return points;
}

double
sumOfDistances(const Points& points, const Point& x)
{
  double sum = 0;
  for (const Point& point : points)
    sum += (point - x).norm();
  return sum;
}

/** \brief Largest distance of points from the origin, the smallest radius that holds
 * all. */
double
reach(const Points& points)
{
  double radius = 0;
  for (const Point& point : points)
    radius = std::max(radius, point.norm());
  return radius;
}

Point
median(const Points& points)
{
  return centroid(Centroid::Median, points, Point::Zero(), reach(points));
}

void
expectNear(const Point& a, const Point& b, double tolerance)
{
  EXPECT_LE((a - b).norm(), tolerance) << a.transpose() << " | " << b.transpose();
}

} // namespace

TEST(Centroid, NamesRoundTrip)
{
  for (const char* name : {"pdt", "mean", "weighted-mean", "median", "weighted-median"})
    EXPECT_EQ(nameOf(fromName<Centroid>(name)), name);
  EXPECT_THROW(fromName<Centroid>("centre"), std::invalid_argument);
}

TEST(Centroid, QueryPointAndMeans)
{
  const Points points = {{0, 0, 0}, {2, 0, 0}, {0, 4, 0}};
  const Point query(1, 0, 0);
  expectNear(centroid(Centroid::QueryPoint, points, query, 5), query, 0);
  expectNear(centroid(Centroid::Mean, points, query, 5), Point(2, 4, 0) / 3, 1e-15);
  // Distances 1, 1, sqrt(17) of 5: linear weights 0.8, 0.8, 1 - sqrt(17)/5.
  const double w = 1 - std::sqrt(17) / 5;
  expectNear(centroid(Centroid::WeightedMean, points, query, 5, Kernel::Linear),
             (0.8 * points[0] + 0.8 * points[1] + w * points[2]) / (1.6 + w),
             1e-15);
  // No weight is left.
  expectNear(centroid(Centroid::WeightedMean, points, query, 5, Weighting::step(0.1)),
             Point(2, 4, 0) / 3,
             1e-15);
}

TEST(Centroid, DegenerateNeighborhoods)
{
  for (const auto& [type, name] : Names<Centroid>::table) {
    SCOPED_TRACE(std::string(name));
    EXPECT_TRUE(centroid(type, {}, Point::Zero(), 1).hasNaN());
    const Point far(5e5, 5e6, 30.1);
    expectNear(centroid(type, {far}, far, 1), far, 0);
    expectNear(centroid(type, Points(1000, far), far, 0), far, 0);
  }
}

TEST(Centroid, MedianOfAllButOneInOnePlaceIsThatPlace)
{
  Points points(5, Point(0.1, 0.2, 0.3));
  points.emplace_back(9, 9, 9);
  expectNear(median(points), points.front(), 0);
}

TEST(Centroid, MedianOfATriangleIsItsFermatPoint)
{
  // From the Fermat point (here the origin), each side is seen under 120 degrees.
  Points points;
  for (int i = 0; i < 3; ++i)
    points.emplace_back((1 + i) * std::cos(2.0943951023931953 * i),
                        (1 + i) * std::sin(2.0943951023931953 * i),
                        0);
  expectNear(median(points), Point::Zero(), 1e-8);
  // With an angle above 120 degrees, the obtuse corner is the median.
  expectNear(median({{-5, 1, 0}, {0, 0, 0}, {5, 1, 0}}), Point::Zero(), 0);
}

TEST(Centroid, MedianOfAConvexQuadrangleIsWhereTheDiagonalsCross)
{
  expectNear(
      median({{0, 0, 0}, {4, 4, 0}, {6, 0, 0}, {0, 3, 0}}), Point(2, 2, 0), 1e-8);
}

TEST(Centroid, MedianOfCollinearPointsIsTheMiddleOne)
{
  expectNear(median({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {7, 7, 7}, {90, 90, 90}}),
             Point(2, 2, 2),
             1e-12);
}

TEST(Centroid, NoPlaceHasASmallerSumOfDistancesThanTheMedian)
{
  for (unsigned seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Points points = cluster(1 + seed % 40, seed);
    const Point found = median(points);
    const double sum = sumOfDistances(points, found);
    for (const double step : {1e-1, 1e-2, 1e-3, 1e-4})
      for (int axis = 0; axis < 3; ++axis)
        for (const int sign : {-1, 1})
          EXPECT_LE(sum,
                    sumOfDistances(points, found + sign * step * Point::Unit(axis)) +
                        1e-13 * sum);
    for (const Point& point : points)
      EXPECT_LE(sum, sumOfDistances(points, point) * (1 + 1e-13));
  }
}

TEST(Centroid, TheSumOfUnitVectorsVanishesAtTheMedian)
{
  // A closed form of the limit, so the iteration must have converged.
  for (unsigned seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    // Wires as well, from thick to vanishingly thin, where plain iteration creeps.
    Points points = cluster(5 + seed % 40, seed);
    for (Point& point : points)
      point = Point(point.x(),
                    point.y() * std::pow(0.1, seed % 7),
                    point.z() * std::pow(0.1, seed % 7));
    const Point found = median(points);
    Point sum = Point::Zero();
    int here = 0;
    for (const Point& point : points) {
      if (point == found)
        ++here;
      else
        sum += (point - found).normalized();
    }
    EXPECT_LE(sum.norm(), here + 1e-7);
  }
}

TEST(Centroid, WeightedMedianWithConstantWeightIsTheMedian)
{
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const Points points = cluster(30, seed);
    expectNear(
        centroid(Centroid::WeightedMedian, points, Point::Zero(), 3, Kernel::Const),
        median(points),
        1e-9);
  }
}

TEST(Centroid, TheWeightedPullVanishesAtTheWeightedMedian)
{
  for (const char* name :
       {"quadratic-inverse", "fermi-dirac-1", "linear", "cs-rbf-5"}) {
    const Weighting weighting(name);
    for (unsigned seed = 1; seed <= 100; ++seed) {
      SCOPED_TRACE(std::string(name) + " seed " + std::to_string(seed));
      const Points points = cluster(40, seed);
      const double radius = reach(points);
      const Point found =
          centroid(Centroid::WeightedMedian, points, Point::Zero(), radius, weighting);
      Point pull = Point::Zero();
      double here = 0;
      for (const Point& point : points) {
        if (point == found)
          here += weighting(0);
        else
          pull +=
              weighting((point - found).norm() / radius) * (point - found).normalized();
      }
      EXPECT_LE(pull.norm(), here + 1e-6);
    }
  }
}

TEST(Centroid, WeightedMedianLeavesAFarClusterAside)
{
  Points points = cluster(60, 7);
  for (Point& point : points)
    point *= 0.1;
  const Point alone = median(points);
  for (const Point& point : cluster(25, 8))
    points.push_back(Point(5, 0, 0) + 0.1 * point);
  const double radius = reach(points);
  const double pulled = (median(points) - alone).norm();
  const double kept =
      (centroid(Centroid::WeightedMedian, points, Point::Zero(), radius) - alone)
          .norm();
  EXPECT_LT(kept, pulled);
}

TEST(Centroid, MovesWithItsPoints)
{
  const Point shift(5e5, 5e6, 100);
  for (const auto& [type, name] : Names<Centroid>::table) {
    SCOPED_TRACE(std::string(name));
    Points points = cluster(25, 3), moved;
    for (const Point& point : points)
      moved.push_back(point + shift);
    expectNear(centroid(type, moved, shift, 3) - shift,
               centroid(type, points, Point::Zero(), 3),
               1e-6);
  }
}
