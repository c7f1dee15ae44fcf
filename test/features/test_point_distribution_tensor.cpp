// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <string>
#include <vector>

#include "features/pdt_fixture.h"

using namespace linelet;
using namespace linelet::test;

TEST_F(PdtEstimation, GivesTheSameWithEverySearch)
{
  const Cloud::Ptr cloud = depthImage();
  for (const auto& [centroid, centroid_name] : Names<Centroid>::table) {
    TensorSettings settings;
    settings.centroid = centroid;
    settings.weighting = Kernel::EaseSine;
    for (const bool by_k : {false, true}) {
      settings.radius = by_k ? 0 : 0.09;
      settings.k = by_k ? 11 : 0;
      settings.engine = Engine::Tree;
      const RecordCloud expected = reference(*cloud, *cloud, settings);
      for (const auto& [name, search] : searches(true)) {
        SCOPED_TRACE(name + " " + std::string(centroid_name) +
                     (by_k ? " k" : " radius"));
        Estimation estimation;
        estimation.setInputCloud(cloud);
        estimation.setSearchMethod(search);
        estimation.setRadiusSearch(settings.radius);
        estimation.setKSearch(static_cast<int>(settings.k));
        estimation.setWeighting(settings.weighting);
        estimation.setCentroid(centroid);
        const RecordCloud records = compute(estimation);
        // The same neighbors in the same order give the same bits; the built-in grid
        // may sum them in another order.
        expectSame(records, expected, search ? 0 : 1e-5f);
        EXPECT_EQ(records.width, 56u);
        EXPECT_EQ(records.height, 42u);
      }
    }
  }
}

TEST_F(PdtEstimation, GivesTheSameWithEverySearchFarFromTheOrigin)
{
  const Cloud::Ptr here = scattered(1500, 1), there = scattered(1500, 1, 5e5f);
  TensorSettings settings;
  settings.radius = 0.75; // many points lie exactly at this distance
  settings.engine = Engine::Tree;
  const RecordCloud expected = reference(*here, *here, settings);
  for (const auto& [name, search] : searches(false)) {
    SCOPED_TRACE(name);
    Estimation estimation;
    estimation.setInputCloud(there);
    estimation.setSearchMethod(search);
    estimation.setRadiusSearch(0.75);
    expectSame(compute(estimation), expected, search ? 0 : 1e-5f);
  }
}

TEST_F(PdtEstimation, KeepsTheSmallEigenvaluesOfAWire)
{
  // In float, the two small eigenvalues of a 1 cm wire would be off by more than 100 %.
  boost::random::mt19937 random(3);
  boost::random::normal_distribution<float> normal;
  auto cloud = pcl::make_shared<Cloud>();
  double yy = 0, zz = 0, yz = 0;
  for (int i = -200; i <= 200; ++i) {
    cloud->emplace_back(0.0025f * static_cast<float>(i),
                        0.005f * normal(random),
                        0.003f * normal(random));
    const auto& p = cloud->back();
    yy += double(p.y) * double(p.y) / 401;
    yz += double(p.y) * double(p.z) / 401;
    zz += double(p.z) * double(p.z) / 401;
  }
  auto middle = pcl::make_shared<pcl::Indices>(pcl::Indices{200});
  (*cloud)[200] = pcl::PointXYZ(0, 0, 0);
  Estimation estimation;
  estimation.setInputCloud(cloud);
  estimation.setIndices(middle);
  estimation.setRadiusSearch(10);
  estimation.setWeighting(Kernel::Const);
  const RecordCloud records = compute(estimation);
  ASSERT_EQ(records.size(), 1u);
  EXPECT_EQ(records[0].neighbors, 401u);
  // The wire's own axis mixes with its cross-section by no more than 1 % here.
  EXPECT_NEAR(records[0].lambda1 + records[0].lambda2, yy + zz, 0.01 * (yy + zz));
  EXPECT_NEAR(
      records[0].lambda1 * records[0].lambda2, yy * zz - yz * yz, 0.02 * (yy * zz));
  EXPECT_GT(records[0].linearity, 0.99f);
}

TEST_F(PdtEstimation, HonorsIndicesAndSearchSurface)
{
  const Cloud::Ptr surface = scattered(800, 5), queries = scattered(60, 6);
  Cloud chosen;
  auto indices = pcl::make_shared<pcl::Indices>();
  for (const int i : {59, 3, 3, 17}) {
    indices->push_back(i);
    chosen.push_back((*queries)[static_cast<std::size_t>(i)]);
  }
  TensorSettings settings;
  settings.radius = 0.8;
  settings.engine = Engine::Tree;
  for (const auto& [name, search] : searches(false)) {
    SCOPED_TRACE(name);
    Estimation estimation;
    estimation.setInputCloud(queries);
    estimation.setSearchSurface(surface);
    estimation.setSearchMethod(search);
    estimation.setRadiusSearch(0.8);
    expectSame(compute(estimation), reference(*surface, *queries, settings), 1e-5f);
    estimation.setIndices(indices);
    const RecordCloud records = compute(estimation);
    EXPECT_EQ(records.width, 4u);
    EXPECT_EQ(records.height, 1u);
    expectSame(records, reference(*surface, chosen, settings), 1e-5f);
  }
}

TEST_F(PdtEstimation, TakesRadiiAndCountsPointByPoint)
{
  const Cloud::Ptr cloud = scattered(300, 7);
  std::vector<double> radii;
  std::vector<unsigned> counts;
  for (std::size_t i = 0; i < cloud->size(); ++i) {
    radii.push_back(0.4 + 0.2 * static_cast<double>(i % 5));
    counts.push_back(5 + i % 4);
  }
  radii[8] = std::numeric_limits<double>::quiet_NaN();
  auto indices = pcl::make_shared<pcl::Indices>(pcl::Indices{8, 100, 33});
  for (const auto& [name, search] : searches(false)) {
    SCOPED_TRACE(name);
    Estimation estimation;
    estimation.setInputCloud(cloud);
    estimation.setSearchMethod(search);
    estimation.setIndices(indices);
    estimation.setRadii(radii);
    const RecordCloud records = compute(estimation);
    ASSERT_EQ(records.size(), 3u);
    EXPECT_FALSE(records.is_dense);
    EXPECT_TRUE(std::isnan(records[0].linearity));
    estimation.setRadii({});
    for (std::size_t i = 1; i < 3; ++i) {
      const auto index = static_cast<std::size_t>((*indices)[i]);
      estimation.setRadiusSearch(radii[index]);
      const RecordCloud one = compute(estimation);
      EXPECT_EQ(one[i].neighbors, records[i].neighbors);
      EXPECT_NEAR(one[i].planarity, records[i].planarity, 1e-5);
    }
    estimation.setRadiusSearch(0);
    estimation.setCounts(counts);
    EXPECT_EQ(compute(estimation)[1].neighbors, 5u);
    EXPECT_EQ(compute(estimation)[2].neighbors, 6u);
    estimation.setRadii({1, 2, 3});
    EXPECT_TRUE(compute(estimation).empty()); // both
    estimation.setCounts({});
    EXPECT_TRUE(compute(estimation).empty()); // too few
  }
}
