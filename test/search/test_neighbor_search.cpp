// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_int_distribution.hpp>
#include <boost/random/uniform_real_distribution.hpp>
#include <gtest/gtest.h>

#include <linelet/search/grid_search.h>
#include <linelet/search/kd_tree.h>
#include <linelet/search/subset_search.h>

using namespace linelet;

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

using Random = boost::random::mt19937;

/** \brief Points on a coarse lattice: many equal distances, many coincident points. */
Points
lattice(std::size_t count, unsigned seed)
{
  Random random(seed);
  boost::random::uniform_int_distribution<int> step(-4, 4);
  Points points;
  for (std::size_t i = 0; i < count; ++i) {
    const int x = step(random), y = step(random);
    points.emplace_back(0.1 * x, 0.1 * y, 0.1 * step(random));
  }
  return points;
}

/** \brief Half of the points in a hundredth of the space. */
Points
uneven(std::size_t count, unsigned seed)
{
  Random random(seed);
  boost::random::uniform_real_distribution<double> unit(-1, 1);
  Points points;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = unit(random), y = unit(random), z = unit(random);
    points.push_back(Point(x, y, z) * (i % 2 ? 1 : 0.05));
  }
  return points;
}

std::vector<std::unique_ptr<NeighborSearch>>
searches(const Points& points, double size)
{
  std::vector<std::unique_ptr<NeighborSearch>> all;
  all.push_back(std::make_unique<KdTree>(points));
  all.push_back(std::make_unique<GridSearch>(points, size));
  return all;
}

std::vector<std::pair<double, Index>>
byDistance(const Points& points, const Point& query)
{
  std::vector<std::pair<double, Index>> sorted;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points[i].allFinite())
      sorted.emplace_back((points[i] - query).squaredNorm(), static_cast<Index>(i));
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

Indices
indicesOf(const std::vector<std::pair<double, Index>>& sorted, std::size_t count)
{
  Indices indices;
  for (std::size_t i = 0; i < std::min(count, sorted.size()); ++i)
    indices.push_back(sorted[i].second);
  std::sort(indices.begin(), indices.end());
  return indices;
}

void
expectSameAsBruteForce(const Points& points, const Points& queries)
{
  for (const auto& search : searches(points, 0.3)) {
    for (const Point& query : queries) {
      const auto sorted = byDistance(points, query);
      Indices found;
      // Radii that are distances in the set, so that points lie on the sphere itself.
      for (const double radius :
           {0.0, 0.1, 0.2, std::sqrt(sorted[9].first), 0.7, 20.0, infinite}) {
        search->within(query, radius, found);
        const auto inside = static_cast<std::size_t>(
            std::count_if(sorted.begin(), sorted.end(), [&](const auto& entry) {
              return entry.first <= radius * radius;
            }));
        EXPECT_EQ(found, indicesOf(sorted, inside)) << "radius " << radius;
      }
      for (const std::size_t count : {1, 2, 7, 50, 100000}) {
        const double farthest = search->nearest(query, count, found);
        EXPECT_EQ(found, indicesOf(sorted, count)) << "k " << count;
        EXPECT_EQ(farthest,
                  std::sqrt(sorted[std::min(count, sorted.size()) - 1].first));
      }
    }
  }
}

} // namespace

TEST(NeighborSearch, FindsWhatBruteForceFindsWithManyTies)
{
  for (unsigned seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    expectSameAsBruteForce(lattice(600, seed), lattice(15, seed + 100));
  }
}

TEST(NeighborSearch, FindsWhatBruteForceFindsInUnevenDensity)
{
  for (unsigned seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    expectSameAsBruteForce(uneven(500, seed), uneven(10, seed + 100));
  }
}

TEST(NeighborSearch, FindsWhatBruteForceFindsFarFromTheOrigin)
{
  Points points = lattice(300, 3), queries = lattice(5, 4);
  for (Points* set : {&points, &queries})
    for (Point& point : *set)
      point += Point(5e5, 5.5e6, 100);
  expectSameAsBruteForce(points, queries);
}

TEST(NeighborSearch, HandlesDegenerateSets)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Points mixed(200, Point(1, 2, 3));
  mixed[7] = Point(nan, 0, 0);
  mixed[9] = Point(0, infinite, 0);
  const std::vector<std::pair<Points, std::size_t>> cases = {
      {{}, 0}, {{Point(nan, nan, nan)}, 0}, {{Point(1, 2, 3)}, 1}, {mixed, 198}};
  for (const auto& [points, finite] : cases) {
    for (const auto& search : searches(points, 0.5)) {
      Indices found = {99};
      EXPECT_EQ(search->nearest(Point(1, 2, 3), 1000, found), 0);
      EXPECT_EQ(found.size(), finite);
      search->within(Point(1, 2, 3), 0, found);
      EXPECT_EQ(found.size(), finite);
      search->within(Point(1, 2, 3), nan, found);
      EXPECT_TRUE(found.empty());
      search->within(Point(1, 2, 3), -1, found);
      EXPECT_TRUE(found.empty());
      search->within(Point(1, nan, 3), 5, found);
      EXPECT_TRUE(found.empty());
      EXPECT_EQ(search->nearest(Point(infinite, 2, 3), 5, found), 0);
      EXPECT_TRUE(found.empty());
      search->nearest(Point(1, 2, 3), 0, found);
      EXPECT_TRUE(found.empty());
    }
  }
}

TEST(SubsetSearch, FindsWhatASearchOverTheSubsetFinds)
{
  for (unsigned seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Points points = lattice(400, seed);
    points[3] = Point(std::nan(""), 0, 0);
    Random random(seed);
    boost::random::uniform_int_distribution<Index> any(0, 399);
    for (const std::size_t size : {0u, 1u, 7u, 150u, 500u}) {
      Indices chosen; // with repetition
      Points subset;
      for (std::size_t i = 0; i < size; ++i) {
        chosen.push_back(i == 5 ? 3 : any(random));
        subset.push_back(points[chosen.back()]);
      }
      const KdTree whole(points), own(subset);
      const SubsetSearch search(whole, points, chosen);
      for (const Point& query : lattice(20, seed + 50)) {
        Indices found, expected;
        for (const double radius : {0.0, 0.15, 0.5}) {
          search.within(query, radius, found);
          own.within(query, radius, expected);
          EXPECT_EQ(found, expected);
        }
        for (const std::size_t count : {1u, 6u, 40u, 1000u}) {
          const double distance = search.nearest(query, count, found);
          EXPECT_EQ(distance, own.nearest(query, count, expected));
          EXPECT_EQ(found, expected);
        }
      }
    }
  }
}

TEST(SubsetSearch, RefusesAnIndexBeyondThePoints)
{
  const Points points = lattice(10, 1);
  const KdTree whole(points);
  EXPECT_THROW(SubsetSearch(whole, points, {2, 10}), std::invalid_argument);
}
