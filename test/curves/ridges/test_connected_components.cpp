// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <limits>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_real_distribution.hpp>
#include <gtest/gtest.h>

#include "curves/ridges/connected_components.h"
#include "curves/ridges/scale_field.h"

using namespace linelet;

namespace {

/** \brief The same, by comparing all pairs. */
std::vector<Indices>
componentsByPairs(const Points& points,
                  double distance,
                  std::size_t least,
                  const ScaleField* scales)
{
  std::vector<double> reach;
  for (const Point& p : points)
    reach.push_back(distance *
                    (scales && p.allFinite() ? std::max(1.0, scales->at(p)) : 1));
  std::vector<Indices> components;
  std::vector<char> seen(points.size(), 0);
  for (Index i = 0; i < points.size(); ++i) {
    if (seen[i] || !points[i].allFinite())
      continue;
    Indices component = {i};
    seen[i] = 1;
    for (std::size_t k = 0; k < component.size(); ++k)
      for (Index j = 0; j < points.size(); ++j)
        if (!seen[j] && (points[j] - points[component[k]]).norm() <=
                            std::max(reach[j], reach[component[k]])) {
          seen[j] = 1;
          component.push_back(j);
        }
    std::sort(component.begin(), component.end());
    if (component.size() >= least)
      components.push_back(component);
  }
  return components;
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

TEST(ConnectedComponents, AreThoseOfAllPairs)
{
  for (unsigned seed = 1; seed <= 30; ++seed) {
    const Points points = randomPoints(300, seed);
    for (const double distance : {0.3, 0.7, 1.0, 1.3, 3.0})
      EXPECT_EQ(connectedComponents(points, distance, 2),
                componentsByPairs(points, distance, 2, nullptr))
          << "seed " << seed << ", distance " << distance;
  }
}

TEST(ConnectedComponents, ReachFartherWhereTheSpacingIsWide)
{
  for (unsigned seed = 1; seed <= 30; ++seed) {
    Points points = randomPoints(300, seed);
    for (Point& p : points) // dense on one side
      p.x() = p.x() > 0 ? p.x() * p.x() : 0.1 * p.x();
    const ScaleField scales(points, 0.5);
    for (const double distance : {0.2, 0.4, 0.7})
      EXPECT_EQ(connectedComponents(points, distance, 3, &scales),
                componentsByPairs(points, distance, 3, &scales))
          << "seed " << seed << ", distance " << distance;
  }
}

TEST(ConnectedComponents, LinkAtTheDistanceItself)
{
  const Points points = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3.0000001, 0, 0}};
  const std::vector<Indices> components = connectedComponents(points, 1, 1);
  ASSERT_EQ(components.size(), 2u);
  EXPECT_EQ(components[0], (Indices{0, 1, 2}));
  EXPECT_EQ(components[1], (Indices{3}));
}

TEST(ConnectedComponents, LeaveOutWhatIsNotFinite)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(connectedComponents({}, 1, 1).empty());
  EXPECT_TRUE(connectedComponents({{nan, 0, 0}, {0, infinity, 0}}, 1, 1).empty());
  EXPECT_EQ(connectedComponents({{nan, 0, 0}, {5e6, -5e6, 1}, {5e6, -5e6, 1}}, 0.1, 2),
            (std::vector<Indices>{{1, 2}}));
}
