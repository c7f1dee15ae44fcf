// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <limits>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_real_distribution.hpp>
#include <gtest/gtest.h>

#include <linelet/search/uniform_grid.h>

#include "search/nearest_walk.h"

using namespace linelet;

namespace {

Points
randomPoints(std::size_t count, const Point& extent, unsigned seed)
{
  boost::random::mt19937 random(seed);
  boost::random::uniform_real_distribution<double> unit(0, 1);
  Points points;
  for (std::size_t i = 0; i < count; ++i)
    points.emplace_back(extent.x() * unit(random),
                        extent.y() * unit(random),
                        extent.z() * unit(random));
  return points;
}

Indices
bruteForce(const Points& points, const Point& query, double radius)
{
  Indices found;
  for (std::size_t i = 0; i < points.size(); ++i)
    if ((points[i] - query).squaredNorm() <= radius * radius)
      found.push_back(static_cast<Index>(i));
  return found;
}

} // namespace

TEST(UniformGrid, FindsWhatBruteForceFinds)
{
  for (unsigned seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Points points =
        randomPoints(300, seed % 2 ? Point(10, 10, 10) : Point(100, 0.1, 0), seed);
    const UniformGrid grid(points, 0.3 * seed);
    for (const Point& query : randomPoints(20, Point(11, 11, 11), seed + 1000)) {
      for (const double radius : {0.0, 0.5, 3.0, 50.0}) {
        Indices found = grid.within(query, radius);
        std::sort(found.begin(), found.end());
        EXPECT_EQ(found, bruteForce(points, query, radius));
      }
      const Indices near = grid.nearestK(query, 7);
      ASSERT_EQ(near.size(), 7u);
      EXPECT_EQ(near.front(), grid.nearest(query));
      const double reach = (points[near.back()] - query).norm();
      EXPECT_EQ(bruteForce(points, query, reach * (1 + 1e-12)).size(), 7u);
    }
  }
}

TEST(UniformGrid, RunsInACylinderHoldAllOfIt)
{
  for (unsigned seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Points points = randomPoints(2000, Point(10, 10, 10), seed);
    if (seed % 3 == 0)
      points.emplace_back(0, 9000, 0); // far away: in the outermost row
    const UniformGrid grid(points, 0.1 * seed);
    const Points ends = randomPoints(40, Point(12, 12, 12), seed + 2000);
    for (std::size_t k = 0; k + 1 < ends.size(); k += 2) {
      const Point from = ends[k] - Point::Constant(1);
      Point to = ends[k + 1] - Point::Constant(1);
      for (int axis = 0; axis < 3; ++axis) // along an axis, or in a single place
        if (seed % 7 == 0 || seed % 5 == static_cast<unsigned>(axis))
          to[axis] = from[axis];
      for (const double radius : {0.0, 0.3, 2.0, 30.0}) {
        std::vector<int> seen(points.size(), 0);
        std::size_t total = 0;
        grid.forEachRunInCylinder(
            from, to, radius, [&](std::size_t begin, std::size_t end) {
              for (std::size_t j = begin; j < end; ++j)
                ++seen[grid.inputIndices()[j]];
              total += end - begin;
            });
        const Point along = to - from;
        std::size_t near = 0;
        for (std::size_t i = 0; i < points.size(); ++i) {
          const Point v = points[i] - from;
          const double t = along.norm() > 0 ? along.dot(v) / along.squaredNorm() : 0;
          const bool within = t >= 0 && t <= 1 && (v - t * along).norm() <= radius;
          near += within;
          EXPECT_TRUE(seen[i] == 1 || (!within && seen[i] == 0)) << i;
        }
        EXPECT_TRUE(along.norm() < 5 || radius > 1 || total < points.size() / 2)
            << total << " for " << near;
      }
    }
  }
  const UniformGrid none({}, 1);
  none.forEachRunInCylinder(
      {0, 0, 0}, {1, 1, 1}, 1, [](std::size_t, std::size_t) { FAIL(); });
}

TEST(UniformGrid, SurvivesDegenerateSets)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(UniformGrid({}, 1).within(Point::Zero(), 1).empty());
  EXPECT_EQ(UniformGrid({}, 1).nearest(Point::Zero()), UniformGrid::none);
  EXPECT_EQ(UniformGrid({Point(nan, 0, 0)}, 1).size(), 0u);
  const UniformGrid same(Points(50, Point(5e5, 5e6, 0)), 1e-3);
  EXPECT_EQ(same.countWithin(Point(5e5, 5e6, 0), 0), 50u);
  EXPECT_EQ(same.nearest(Point(5e5, 5e6, 1)), 0u);
  EXPECT_EQ(same.nearestK(Point(5e5, 5e6, 1), 99).size(), 50u);
  EXPECT_EQ(same.countWithin(Point(nan, 0, 0), 1), 0u);
  EXPECT_THROW(UniformGrid({}, 0), std::invalid_argument);
  // A table as wide as the extent in rows of this size would not fit into memory.
  const UniformGrid far({Point(0, 0, 0), Point(1e6, 1e6, 1e6)}, 1e-6);
  EXPECT_EQ(far.nearest(Point(9e5, 9e5, 9e5)), 1u);
  EXPECT_EQ(far.countWithin(Point(0, 0, 0), std::numeric_limits<double>::infinity()),
            2u);
}

// If one far point made the rows of all others wide, queries would visit them all.
TEST(UniformGrid, FindsWhatBruteForceFindsWithFarOutliers)
{
  Points points = randomPoints(3000, Point(10, 10, 10), 3);
  points.emplace_back(1e7, -1e7, 1e7);
  points.emplace_back(-1e7, 1e7, 5);
  points.emplace_back(5, 5, -1e9);
  const UniformGrid grid(points, 0.5);
  for (const std::size_t i : {0u, 17u, 2999u, 3000u, 3001u, 3002u})
    for (const double radius : {0.0, 0.7, 4.0, 3e7}) {
      Indices found = grid.within(points[i], radius);
      std::sort(found.begin(), found.end());
      EXPECT_EQ(found, bruteForce(points, points[i], radius));
    }
  EXPECT_EQ(grid.nearest(Point(9e6, -9e6, 9e6)), 3000u);
}

// Rows are skipped by their distance: never one that holds the nearest point, or an
// equally near one with a lower index.
TEST(UniformGrid, FindsTheNearestPoint)
{
  for (unsigned seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Points points = randomPoints(seed % 3 == 0 ? 40 : 400,
                                 seed % 2 ? Point(10, 10, 10) : Point(100, 0.1, 3),
                                 seed);
    if (seed % 4 == 0) // a lattice: borders of rows, equal distances, duplicates
      for (Point& p : points)
        p = p.array().round();
    if (seed % 5 == 0)
      points.emplace_back(1e5, -1e5, 1e5);
    const Point offset = seed % 7 == 0 ? Point(5e5, 5.5e6, 300) : Point(0, 0, 0);
    for (Point& p : points)
      p += offset;
    const UniformGrid grid(points, seed % 4 == 0 ? 1 : 0.05 * seed);
    Points queries = randomPoints(40, Point(14, 14, 14), seed + 1000);
    for (Point& q : queries)
      q = (seed % 4 == 0 ? Point((2 * q).array().round() / 2) : q) + offset -
          Point(2, 2, 2);
    queries.push_back(offset + Point(300, -200, 100));
    queries.push_back(points[7]);
    for (const Point& query : queries) {
      Index expected = 0;
      const auto squared = [&](Index i) { return (points[i] - query).squaredNorm(); };
      for (std::size_t i = 1; i < points.size(); ++i)
        if (squared(static_cast<Index>(i)) < squared(expected))
          expected = static_cast<Index>(i);
      EXPECT_EQ(grid.nearest(query), expected);
      EXPECT_EQ(grid.nearestK(query, 1), Indices{expected});
      const double distance = std::sqrt(squared(expected));
      EXPECT_EQ(grid.nearest(query, distance * (1 + 1e-9) + 1e-12), expected);
      EXPECT_EQ(grid.nearest(query, distance * (1 - 1e-9) - 1e-12), UniformGrid::none);
    }
  }
}

TEST(UniformGrid, FindsTheNearestFromAnyInitialRadius)
{
  const Points points = randomPoints(200, Point(10, 10, 10), 3);
  const UniformGrid grid(points, 1);
  std::vector<UniformGrid::Neighbor> found;
  for (const double radius : {1e-3, 1.0, 5.0, 100.0})
    for (const std::size_t count : {1u, 7u, 150u, 500u}) {
      const Point query(4, 5, 6);
      grid.nearestK(query, count, radius, found);
      std::vector<UniformGrid::Neighbor> all;
      for (std::size_t i = 0; i < points.size(); ++i)
        all.emplace_back((points[i] - query).squaredNorm(), static_cast<Index>(i));
      std::sort(all.begin(), all.end());
      all.resize(std::min(count, all.size()));
      EXPECT_EQ(found, all) << "radius " << radius << ", count " << count;
    }
}

TEST(NearestWalk, VisitsEachPointOnceWithItsNearest)
{
  for (unsigned seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Points points =
        randomPoints(250, seed % 2 ? Point(10, 10, 10) : Point(100, 0.1, 0), seed);
    points.insert(points.end(), 10, points.front()); // copies
    const UniformGrid grid(points, 0.3 * seed);
    NearestWalk walk(points, grid, 7);
    std::vector<int> visits(points.size(), 0);
    Indices some; // not all
    for (Index i = 20; i < points.size(); ++i)
      some.push_back(i);
    walk(some.data(), some.data() + some.size(), [&](Index i, const auto& found) {
      ++visits[i];
      std::vector<UniformGrid::Neighbor> all;
      for (std::size_t k = 0; k < points.size(); ++k)
        all.emplace_back((points[k] - points[i]).squaredNorm(), static_cast<Index>(k));
      std::partial_sort(all.begin(), all.begin() + 7, all.end());
      all.resize(7);
      EXPECT_EQ(found, all);
    });
    for (Index i = 0; i < points.size(); ++i)
      EXPECT_EQ(visits[i], i < 20 ? 0 : 1) << i;
  }
}

TEST(NearestWalk, OfFewPointsFindsAll)
{
  const Points points = {{0, 0, 0}, {1, 0, 0}, {5, 0, 0}};
  const UniformGrid grid(points, 0.5);
  NearestWalk walk(points, grid, 7);
  const Indices all = {0, 1, 2};
  std::size_t visits = 0;
  walk(all.data(), all.data() + 3, [&](Index i, const auto& found) {
    EXPECT_EQ(found.size(), 3u);
    EXPECT_EQ(found.front().second, i);
    ++visits;
  });
  EXPECT_EQ(visits, 3u);
}
