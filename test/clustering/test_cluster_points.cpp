// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include <gtest/gtest.h>

#include "clustering/cluster_fixture.h"

using namespace linelet;
using namespace linelet::test;

namespace {

/** \brief Count, mean and covariance of every representative are those of its members,
 * summed in long double. */
void
expectMomentsOfMembers(const Points& points, const Clusters& clusters, double cell)
{
  const auto members = membersOf(clusters);
  for (std::size_t k = 0; k < members.size(); ++k) {
    const Representative& r = clusters.representatives[k];
    ASSERT_EQ(members[k].size(), r.count);
    using Long = Eigen::Matrix<long double, 3, 1>;
    Long mean = Long::Zero();
    for (const Index i : members[k])
      mean += points[i].cast<long double>();
    mean /= static_cast<long double>(members[k].size());
    Eigen::Matrix<long double, 3, 3> covariance;
    covariance.setZero();
    for (const Index i : members[k]) {
      const Long d = points[i].cast<long double>() - mean;
      covariance += d * d.transpose();
    }
    covariance /= static_cast<long double>(members[k].size());
    EXPECT_LT((r.center - mean.cast<double>()).cwiseAbs().maxCoeff(), 4e-6 * cell);
    EXPECT_LT((r.tensor.matrix() - covariance.cast<double>()).cwiseAbs().maxCoeff(),
              1e-5 * cell * cell);
  }
}

TEST(ClusterPoints, WithoutMovesAreTheBoxesOfTheGrid)
{
  constexpr unsigned seed = 3;
  SCOPED_TRACE(seed);
  const Points points = house(20000, seed);
  constexpr double leaf = 0.8;
  const Clusters clusters = clusterPoints(points, settingsOf(leaf, 0));
  const CellKey cells = {static_cast<int>(clusters.cells[0]),
                         static_cast<int>(clusters.cells[1]),
                         static_cast<int>(clusters.cells[2])};
  const auto home = homes(points, lowest(points), Point::Constant(leaf), cells);
  std::map<CellKey, std::size_t> counts;
  for (const CellKey& cell : home)
    ++counts[cell];
  ASSERT_EQ(clusters.representatives.size(), counts.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    EXPECT_EQ(clusters.representatives[clusters.cluster_of[i]].cell, home[i]);
  for (const Representative& r : clusters.representatives)
    EXPECT_EQ(r.count, counts[r.cell]);
  expectMomentsOfMembers(points, clusters, leaf);
}

/** \brief Large clouds are summed with SIMD, run by run of points in one cell: runs of
 * every length, across blocks, interrupted by points that are left out. */
TEST(ClusterPoints, MomentsHoldForLongAndShortRuns)
{
  constexpr unsigned seed = 12;
  SCOPED_TRACE(seed);
  Points points = house(150001, seed);
  const auto third = static_cast<std::ptrdiff_t>(points.size() / 3);
  std::sort(points.begin(), points.begin() + third, [](const Point& a, const Point& b) {
    return std::floor(a.x()) != std::floor(b.x()) ? a.x() < b.x() : a.y() < b.y();
  });
  std::sort(points.begin() + third,
            points.begin() + 2 * third,
            [](const Point& a, const Point& b) { return a.y() < b.y(); });
  for (std::size_t i = 0; i < points.size(); i += 997)
    points[i][static_cast<Eigen::Index>(i % 3)] =
        i % 2 == 0 ? std::nan("") : std::numeric_limits<double>::infinity();
  for (const unsigned moves : {0U, 2U}) {
    SCOPED_TRACE(moves);
    ClusterSettings settings = settingsOf(0.8, moves);
    const Clusters clusters = clusterPoints(points, settings);
    expectMomentsOfMembers(points, clusters, 0.8);
    for (std::size_t i = 0; i < points.size(); ++i)
      ASSERT_EQ(clusters.cluster_of[i] == Clusters::none, !points[i].allFinite());
    settings.threads = 3;
    EXPECT_EQ(clusterPoints(points, settings).cluster_of, clusters.cluster_of);
  }
}

TEST(ClusterPoints, MomentsHoldUnderEveryRuleAndFarFromTheOrigin)
{
  constexpr unsigned seed = 4;
  Points points = house(20000, seed);
  for (Point& p : points)
    p += Point(5e5, 5.7e6, 300);
  std::vector<double> field;
  for (const Point& p : points)
    field.push_back(std::sin(p.x()) * p.y());
  for (const MoveRule rule : {MoveRule::Plane, MoveRule::Population, MoveRule::Field}) {
    SCOPED_TRACE(std::string(nameOf(rule)));
    expectMomentsOfMembers(
        points, clusterPoints(points, settingsOf(0.8, 3, rule), field), 0.8);
  }
}

TEST(ClusterPoints, AreTheSameBitsForAnyThreadsAndAnyOrder)
{
  constexpr unsigned seed = 5;
  const Points points = house(30000, seed);
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  boost::random::mt19937 random(seed);
  for (std::size_t i = order.size() - 1; i > 0; --i)
    std::swap(order[i], order[random() % (i + 1)]);
  Points shuffled;
  for (const std::size_t i : order)
    shuffled.push_back(points[i]);
  for (const MoveRule rule : {MoveRule::Plane, MoveRule::Population})
    for (const double leaf : {0.05, 0.7}) { // as many cells as points, and few
      ClusterSettings settings = settingsOf(leaf, 2, rule);
      settings.threads = 1;
      const Clusters one = clusterPoints(points, settings);
      for (const unsigned threads : {2U, 3U, 7U}) {
        settings.threads = threads;
        const Clusters some = clusterPoints(points, settings);
        const Clusters mixed = clusterPoints(shuffled, settings);
        ASSERT_EQ(some.cluster_of, one.cluster_of);
        ASSERT_EQ(mixed.representatives.size(), one.representatives.size());
        for (std::size_t k = 0; k < one.representatives.size(); ++k)
          for (const Clusters* other : {&some, &mixed}) {
            const Representative &a = one.representatives[k],
                                 &b = other->representatives[k];
            EXPECT_EQ(a.center, b.center);
            EXPECT_EQ(a.tensor.matrix(), b.tensor.matrix());
            EXPECT_EQ(a.count, b.count);
          }
        for (std::size_t i = 0; i < order.size(); ++i)
          ASSERT_EQ(mixed.cluster_of[i], one.cluster_of[order[i]]);
      }
    }
}

TEST(ClusterPoints, FindAGridForANumberOfRepresentatives)
{
  const Points points = house(50000, 6);
  for (const std::size_t wanted : {1U, 40U, 900U, 7000U}) {
    ClusterSettings settings;
    settings.count = wanted;
    settings.moves = 0;
    const Clusters clusters = clusterPoints(points, settings);
    EXPECT_NEAR(static_cast<double>(clusters.representatives.size()),
                static_cast<double>(wanted),
                std::max(1.0, 0.05 * static_cast<double>(wanted)));
  }
}

TEST(ClusterPoints, FillTheViewOfACameraWithCellsOfSimilarProportions)
{
  constexpr unsigned seed = 8;
  boost::random::mt19937 random(seed);
  boost::random::uniform_real_distribution<double> uniform(-50, 50);
  Points points;
  for (int i = 0; i < 20000; ++i)
    points.emplace_back(uniform(random), uniform(random), uniform(random) / 10);
  ClusterSettings settings;
  settings.cells = {12, 9, 10};
  settings.moves = 0;
  Camera camera;
  camera.lookAt(Point(-60, 0, 8), Point(0, 0, 0));
  camera.field_of_view = 50;
  camera.near = 5;
  camera.far = 80;
  settings.camera = camera;
  const Clusters clusters = clusterPoints(points, settings);
  expectMomentsOfMembers(points, clusters, 20);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point pixel = camera.project(points[i]);
    const bool seen = pixel.z() >= 5 && pixel.z() <= 80 && pixel.x() >= 0 &&
                      pixel.x() <= 640 && pixel.y() >= 0 && pixel.y() <= 480;
    ASSERT_EQ(clusters.cluster_of[i] != Clusters::none, seen);
    if (!seen)
      continue;
    const CellKey cell = {
        static_cast<int>(pixel.x() / 640 * 12),
        static_cast<int>(pixel.y() / 480 * 9),
        static_cast<int>(std::log(pixel.z() / 5) / std::log(80. / 5) * 10)};
    EXPECT_EQ(clusters.representatives[clusters.cluster_of[i]].cell, cell);
  }
}

TEST(ClusterPoints, HaveMeansAndModesOfTheirMembersValues)
{
  const Points points = {Point(0, 0, 0),
                         Point(0.1, 0, 0),
                         Point(0.2, 0, 0),
                         Point(3, 0, 0),
                         Point(3.1, 0, 0)};
  const Clusters clusters = clusterPoints(points, settingsOf(1, 0));
  ASSERT_EQ(clusters.representatives.size(), 2u);
  const double nan = std::nan("");
  const auto means = clusterMeans(clusters, {1e15, 1e15 + 1, nan, nan, nan});
  EXPECT_EQ(means[0], 1e15 + 0.5);
  EXPECT_TRUE(std::isnan(means[1]));
  EXPECT_EQ(clusterModes(clusters, {2, 6, 6, 9, 2}), (std::vector<double>{6, 2}));
}

// The outside of a ball is known, and normals toward empty cells point there. Cells are
// half a unit wide and considered up to two cells away, which costs a few degrees.
TEST(ClusterPoints, NormalsTowardEmptyCellsPointOutOfABall)
{
  constexpr unsigned seed = 8;
  SCOPED_TRACE(seed);
  boost::random::mt19937 random(seed);
  boost::random::uniform_real_distribution<double> uniform(-5, 5);
  Points ball;
  while (ball.size() < 400000)
    if (const Point p(uniform(random), uniform(random), uniform(random)); p.norm() < 5)
      ball.push_back(p + Point(1000, 2000, 30));
  ClusterSettings settings = settingsOf(0.5, 0);
  settings.normals = NormalRule::EmptyCells;
  const Clusters clusters = clusterPoints(ball, settings);
  ASSERT_EQ(clusters.normals.size(), clusters.representatives.size());
  std::size_t surface = 0, inside = 0;
  double sum = 0;
  for (std::size_t i = 0; i < clusters.normals.size(); ++i) {
    const Point out = clusters.representatives[i].center - Point(1000, 2000, 30);
    if (out.norm() < 5 - 4 * 0.5) { // no empty cell within two
      EXPECT_TRUE(clusters.normals[i].isZero());
      ++inside;
    }
    else if (out.norm() > 4.5) {
      EXPECT_NEAR(clusters.normals[i].norm(), 1, 1e-12);
      const double cosine = clusters.normals[i].dot(out.normalized());
      EXPECT_GT(cosine, std::cos(30 / 57.3));
      sum += std::acos(std::min(1.0, cosine)) * 57.3;
      ++surface;
    }
  }
  EXPECT_GT(inside, 500U);
  ASSERT_GT(surface, 500U);
  EXPECT_LT(sum / static_cast<double>(surface), 8);
}

// A wall with one point per cell has hardly any covariance, but still a normal.
TEST(ClusterPoints, NormalsTowardEmptyCellsNeedOnePointPerCell)
{
  Points wall;
  for (int i = 0; i < 40; ++i)
    for (int k = 0; k < 30; ++k)
      wall.emplace_back(0.3, i + 0.5, k + 0.5);
  ClusterSettings settings = settingsOf(1, 0);
  settings.normals = NormalRule::EmptyCells;
  const Clusters clusters = clusterPoints(wall, settings);
  ASSERT_EQ(clusters.normals.size(), wall.size());
  for (std::size_t i = 0; i < wall.size(); ++i) {
    const Point& p = clusters.representatives[i].center;
    if (p.y() > 3 && p.y() < 37 && p.z() > 3 && p.z() < 27) {
      EXPECT_NEAR(std::abs(clusters.normals[i].x()), 1, 1e-9) << p.transpose();
    }
  }
  settings.normals = NormalRule::Tensor;
  EXPECT_TRUE(clusterPoints(wall, settings).normals.empty());
}

} // namespace
