// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include <linelet/tensor/eigen_analysis.h>

#include "clustering/cluster_fixture.h"

using namespace linelet;
using namespace linelet::test;

namespace {

/** \brief Sum of squared distances of the points to the planes of their cells. */
double
distancesToPlanes(const Points& points, const Clusters& clusters)
{
  double sum = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Representative& r = clusters.representatives[clusters.cluster_of[i]];
    const double distance = eigenAnalysis(r.tensor).normal().dot(points[i] - r.center);
    sum += distance * distance;
  }
  return sum;
}

class Moves : public testing::TestWithParam<MoveRule> {};

TEST_P(Moves, GoNoFartherThanOneCellAndLoseNoPoint)
{
  const Points points = house(20000, 11);
  std::vector<double> field;
  for (const Point& p : points)
    field.push_back(std::cos(3 * p.x()) + p.z());
  const Clusters still = clusterPoints(points, settingsOf(0.7, 0));
  std::size_t before = 0;
  for (const unsigned moves : {1U, 2U, 5U, 20U}) {
    const Clusters moved =
        clusterPoints(points, settingsOf(0.7, moves, GetParam()), field);
    std::size_t sum = 0, gone = 0;
    for (const Representative& r : moved.representatives)
      sum += r.count;
    EXPECT_EQ(sum, points.size());
    EXPECT_LE(moved.representatives.size(), still.representatives.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto& a = still.representatives[still.cluster_of[i]].cell;
      const auto& b = moved.representatives[moved.cluster_of[i]].cell;
      const int steps =
          std::abs(a[0] - b[0]) + std::abs(a[1] - b[1]) + std::abs(a[2] - b[2]);
      ASSERT_LE(steps, 1);
      gone += steps == 1 ? 1 : 0;
    }
    EXPECT_GT(gone, before); // every additional pass still improves this cloud
    before = gone / 2;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Rules,
    Moves,
    testing::Values(MoveRule::Plane, MoveRule::Population, MoveRule::Field),
    [](const auto& rule) { return std::string(nameOf(rule.param)); });

TEST(MovesByPlane, NeverRaiseTheSumOfSquaredDistances)
{
  for (const unsigned seed : {1U, 2U, 3U}) {
    SCOPED_TRACE(seed);
    const Points points = house(15000, seed);
    double before =
        distancesToPlanes(points, clusterPoints(points, settingsOf(0.9, 0)));
    const double at_first = before;
    for (unsigned moves = 1; moves < 8; ++moves) {
      const double now =
          distancesToPlanes(points, clusterPoints(points, settingsOf(0.9, moves)));
      EXPECT_LE(now, before * (1 + 1e-9)) << moves;
      before = now;
    }
    EXPECT_LT(before, 0.6 * at_first);
  }
}

TEST(MovesByPopulation, NeverRaiseTheSumOfSquaredPopulations)
{
  for (const unsigned seed : {1U, 2U, 3U}) {
    SCOPED_TRACE(seed);
    Points points = house(15000, seed);
    for (Point& p : points) // denser toward one side
      p.x() *= p.x() / 20;
    double before = 1e300, at_first = 0;
    for (unsigned moves = 0; moves < 12; ++moves) {
      double sum = 0;
      for (const Representative& r :
           clusterPoints(points, settingsOf(0.9, moves, MoveRule::Population))
               .representatives)
        sum += static_cast<double>(r.count) * r.count;
      EXPECT_LE(sum, before) << moves;
      before = sum;
      at_first = moves == 0 ? sum : at_first;
    }
    EXPECT_LT(before, 0.97 * at_first);
  }
}

TEST(MovesByPopulation, TakeThePointsNearestToTheBorder)
{
  // 96 points along the first cell, 6 along the second: a pass lets 15 move, the points
  // of two of the eight steps of 1/16, six each.
  Points points;
  for (int i = 0; i < 96; ++i)
    points.emplace_back((i + 0.5) / 96, 0, 0);
  for (int i = 0; i < 6; ++i)
    points.emplace_back(1 + (i + 0.5) / 6, 0, 0);
  points.front().x() = 0;
  points.back().x() = 2;
  ClusterSettings settings = settingsOf(0, 1, MoveRule::Population);
  settings.cells = {2, 1, 1};
  const Clusters clusters = clusterPoints(points, settings);
  ASSERT_EQ(clusters.representatives.size(), 2u);
  EXPECT_EQ(clusters.representatives[0].count, 84u);
  for (std::size_t i = 0; i < 96; ++i)
    EXPECT_EQ(clusters.cluster_of[i], i < 84 ? 0u : 1u) << i;
}

TEST(MovesByField, NeverLowerTheMeanOfACell)
{
  const Points points = house(15000, 21);
  std::vector<double> field;
  for (const Point& p : points)
    field.push_back(std::sin(p.x()) + 0.3 * p.y());
  field[17] = std::nan("");
  std::map<CellKey, double> before;
  for (unsigned moves = 0; moves < 6; ++moves) {
    const Clusters clusters =
        clusterPoints(points, settingsOf(0.9, moves, MoveRule::Field), field);
    const std::vector<double> means = clusterMeans(clusters, field);
    for (std::size_t k = 0; k < means.size(); ++k) {
      double& mean =
          before.try_emplace(clusters.representatives[k].cell, means[k]).first->second;
      // The field is stored as integers, 2^30 over its range.
      EXPECT_GE(means[k], mean - 1e-8) << moves;
      mean = means[k];
    }
  }
}

} // namespace
