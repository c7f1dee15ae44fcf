// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <limits>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_real_distribution.hpp>
#include <gtest/gtest.h>

#include "curves/refined/refined_part.h"
#include "curves/refined/scale_field.h"

using namespace linelet;

namespace {

/** \brief The same by looking at all pairs, part by part. */
std::vector<Indices>
partsByPairs(const Points& points,
             double distance,
             std::size_t least,
             const ScaleField* scales)
{
  std::vector<double> reach;
  for (const Point& p : points)
    reach.push_back(distance *
                    (scales && p.allFinite() ? std::max(1.0, scales->at(p)) : 1));
  std::vector<Indices> parts;
  std::vector<char> seen(points.size(), 0);
  for (Index i = 0; i < points.size(); ++i) {
    if (seen[i] || !points[i].allFinite())
      continue;
    Indices part = {i};
    seen[i] = 1;
    for (std::size_t k = 0; k < part.size(); ++k)
      for (Index j = 0; j < points.size(); ++j)
        if (!seen[j] && (points[j] - points[part[k]]).norm() <=
                            std::max(reach[j], reach[part[k]])) {
          seen[j] = 1;
          part.push_back(j);
        }
    std::sort(part.begin(), part.end());
    if (part.size() >= least)
      parts.push_back(part);
  }
  return parts;
}

Points
randomPoints(std::size_t count, unsigned seed)
{
  boost::random::mt19937 random(seed);
  boost::random::uniform_real_distribution<double> uniform(-10, 10);
  Points points;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = uniform(random), y = uniform(random), z = uniform(random);
    points.emplace_back(x, y, 0.1 * z);
  }
  return points;
}

} // namespace

TEST(ConnectedParts, AreThoseOfAllPairs)
{
  for (unsigned seed = 1; seed <= 30; ++seed) {
    const Points points = randomPoints(300, seed);
    for (const double distance : {0.3, 0.7, 1.0, 1.3, 3.0})
      EXPECT_EQ(connectedParts(points, distance, 2),
                partsByPairs(points, distance, 2, nullptr))
          << "seed " << seed << ", distance " << distance;
  }
}

TEST(ConnectedParts, ReachFartherWhereTheSpacingIsWide)
{
  for (unsigned seed = 1; seed <= 30; ++seed) {
    Points points = randomPoints(300, seed);
    for (Point& p : points) // dense on one side
      p.x() = p.x() > 0 ? p.x() * p.x() : 0.1 * p.x();
    const ScaleField scales(points, 0.5);
    for (const double distance : {0.2, 0.4, 0.7})
      EXPECT_EQ(connectedParts(points, distance, 3, &scales),
                partsByPairs(points, distance, 3, &scales))
          << "seed " << seed << ", distance " << distance;
  }
}

TEST(ConnectedParts, LinkAtTheDistanceItself)
{
  const Points points = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3.0000001, 0, 0}};
  const std::vector<Indices> parts = connectedParts(points, 1, 1);
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[0], (Indices{0, 1, 2}));
  EXPECT_EQ(parts[1], (Indices{3}));
}

TEST(ConnectedParts, LeaveOutWhatIsNotFinite)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(connectedParts({}, 1, 1).empty());
  EXPECT_TRUE(connectedParts({{nan, 0, 0}, {0, infinity, 0}}, 1, 1).empty());
  EXPECT_EQ(connectedParts({{nan, 0, 0}, {5e6, -5e6, 1}, {5e6, -5e6, 1}}, 0.1, 2),
            (std::vector<Indices>{{1, 2}}));
}
