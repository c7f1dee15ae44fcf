// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "clustering/cluster_fixture.h"

using namespace linelet;
using namespace linelet::test;

namespace {

constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();

TEST(ClusterEdges, NothingGivesNothing)
{
  const Clusters empty = clusterPoints({}, settingsOf(1, 2));
  EXPECT_TRUE(empty.representatives.empty());
  EXPECT_TRUE(empty.cluster_of.empty());
  const Clusters unknown =
      clusterPoints({Point(nan_value, 0, 0), Point(0, 0, nan_value)}, settingsOf(1, 2));
  EXPECT_TRUE(unknown.representatives.empty());
  EXPECT_EQ(unknown.cluster_of, (Indices{Clusters::none, Clusters::none}));
}

TEST(ClusterEdges, OnePointOrOnePlaceIsOneRepresentative)
{
  for (const std::size_t count : {1U, 2U, 100U})
    for (const double offset : {0., 1e7})
      for (const bool by_cells : {false, true}) {
        ClusterSettings settings = settingsOf(by_cells ? 0 : 0.5, 3);
        if (by_cells)
          settings.cells = {7, 5, 3};
        const Point place(offset + 0.1, -offset, 3);
        const Clusters clusters = clusterPoints(Points(count, place), settings);
        ASSERT_EQ(clusters.representatives.size(), 1u);
        EXPECT_EQ(clusters.representatives[0].count, count);
        EXPECT_LT((clusters.representatives[0].center - place).norm(), 4e-6);
        EXPECT_LT(clusters.representatives[0].tensor.trace(), 1e-10);
      }
}

TEST(ClusterEdges, NanAndInfinityAreLeftOut)
{
  Points points = house(1000, 1);
  points[3].x() = nan_value;
  points[5].z() = std::numeric_limits<double>::infinity();
  const Clusters clusters = clusterPoints(points, settingsOf(1, 1));
  std::size_t sum = 0;
  for (const Representative& r : clusters.representatives)
    sum += r.count;
  EXPECT_EQ(sum, 998u);
  EXPECT_EQ(clusters.cluster_of[3], Clusters::none);
  EXPECT_EQ(clusters.cluster_of[5], Clusters::none);
}

TEST(ClusterEdges, HugeGridsWorkLikeSmallOnes)
{
  const Points points = house(5000, 2);
  // More cells than would fit into memory.
  std::size_t before = 0;
  for (const double n : {1., 10., 100., 1000., 4000.}) {
    ClusterSettings settings;
    settings.cells = {n, n, n};
    const Clusters clusters = clusterPoints(points, settings);
    EXPECT_GT(clusters.representatives.size(), before);
    before = clusters.representatives.size();
  }
  EXPECT_GT(before, 4900u);
  ClusterSettings settings;
  settings.cells = {1e5, 1e5, 1e5};
  EXPECT_THROW(clusterPoints(points, settings), std::invalid_argument);
  EXPECT_THROW(clusterPoints(points, settingsOf(1e-7, 0)), std::invalid_argument);
}

TEST(ClusterEdges, InvalidSettingsAreRefused)
{
  const Points points = house(10, 1);
  const auto refuses = [&](const auto& change) {
    ClusterSettings settings = settingsOf(1, 1);
    change(settings);
    EXPECT_THROW(clusterPoints(points, settings), std::invalid_argument);
  };
  refuses([](ClusterSettings& s) { s.leaf = 0; });
  refuses([](ClusterSettings& s) { s.leaf = -1; });
  refuses([](ClusterSettings& s) { s.leaf = nan_value; });
  refuses([](ClusterSettings& s) { s.count = 5; });
  refuses([](ClusterSettings& s) { s.cells = {1, 1, 1}; });
  refuses([](ClusterSettings& s) { s.leaf = 0, s.cells = {1, 1}; });
  refuses([](ClusterSettings& s) { s.leaf = 0, s.cells = {1, 1, 0}; });
  refuses([](ClusterSettings& s) { s.leaf = 0, s.cells = {1, 1, 1.5}; });
  refuses([](ClusterSettings& s) { s.border = 0; });
  refuses([](ClusterSettings& s) { s.border = 0.6; });
  refuses([](ClusterSettings& s) { s.camera = Camera(); });
  refuses([](ClusterSettings& s) { s.move_by = MoveRule::Field; });
}

TEST(ClusterEdges, MoreRepresentativesThanPointsAreNotInvented)
{
  const Points points = house(500, 3);
  ClusterSettings settings;
  settings.count = 100000;
  const Clusters clusters = clusterPoints(points, settings);
  EXPECT_GT(clusters.representatives.size(), 490u);
  EXPECT_LE(clusters.representatives.size(), 500u);
}

TEST(ClusterEdges, ACameraThatSeesNothingFindsNothing)
{
  ClusterSettings settings;
  settings.cells = {4, 4, 4};
  Camera camera;
  camera.lookAt(Point(0, 0, 100), Point(0, 0, 200));
  settings.camera = camera;
  const Clusters clusters = clusterPoints(house(100, 1), settings);
  EXPECT_TRUE(clusters.representatives.empty());
}

} // namespace
