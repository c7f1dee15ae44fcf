// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include <linelet/features/multi_scale_shape.h>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <gtest/gtest.h>

#include <pcl/console/print.h>
#include <pcl/conversions.h>
#include <pcl/PCLPointCloud2.h>
#include <pcl/search/kdtree.h>

#include <linelet/search/kd_tree.h>
#include <linelet/search/pcl_search.h>

#include "pdt_fixture.h"

using namespace linelet;

namespace {

using Records = pcl::PointCloud<MultiScaleShape>;

/** \brief A noisy wire beside a few scattered points. */
template <typename PointT>
typename pcl::PointCloud<PointT>::Ptr
wire()
{
  boost::random::mt19937 random(3);
  boost::random::normal_distribution<float> normal;
  auto cloud = pcl::make_shared<pcl::PointCloud<PointT>>();
  for (int i = 0; i < 300; ++i) {
    PointT point;
    point.x = 0.05F * static_cast<float>(i);
    point.y = 0.02F * normal(random) + (i % 20 == 0 ? 1 : 0);
    point.z = 0.02F * normal(random);
    cloud->push_back(point);
  }
  return cloud;
}

bool
same(const MultiScaleShape& a, const MultiScaleShape& b)
{
  const auto equal = [](float x, float y) {
    return x == y || (std::isnan(x) && std::isnan(y));
  };
  return equal(a.linearity, b.linearity) && equal(a.planarity, b.planarity) &&
         equal(a.sphericity, b.sphericity) &&
         equal(a.optimal_radius, b.optimal_radius) && equal(a.blend, b.blend) &&
         equal(a.linearity_sum, b.linearity_sum) &&
         equal(a.linearity_max, b.linearity_max) &&
         equal(a.min_sphericity, b.min_sphericity) && equal(a.major_x, b.major_x) &&
         equal(a.major_y, b.major_y) && equal(a.major_z, b.major_z) &&
         a.neighbors == b.neighbors && a.first_neighbors == b.first_neighbors &&
         a.scale == b.scale;
}

/** \brief Silences PCL while errors are provoked. */
class MultiScaleShapeFeatureTest : public testing::Test {
protected:
  void
  SetUp() override
  {
    pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
  }
};

template <typename PointT>
void
expectCore()
{
  const auto cloud = wire<PointT>();
  MultiScaleShapeFeature<PointT> feature;
  feature.setInputCloud(cloud);
  Records out;
  feature.compute(out);
  const Points points = pointsOf(*cloud);
  const MultiScaleShapes core = multiScaleShapes(points, points);
  ASSERT_EQ(out.size(), cloud->size());
  EXPECT_TRUE(out.is_dense);
  for (std::size_t i = 0; i < out.size(); ++i)
    ASSERT_TRUE(same(out[i], core.shapes[i])) << out[i];
  EXPECT_EQ(feature.getRadii(), core.radii);
  EXPECT_EQ(feature.getScaleUnit(), core.scale_unit);
  EXPECT_EQ(feature.getNoiseRate(), linelet::noiseRate(core.shapes));
  EXPECT_EQ(feature.getNoiseWidth(), linelet::noiseWidth(core.shapes));
  EXPECT_GT(feature.getNoiseWidth(), 0.01);
  ASSERT_EQ(feature.getGraphs().size(), cloud->size());
  EXPECT_EQ(feature.getGraphs()[7].size(), core.radii.size());
}

TEST_F(MultiScaleShapeFeatureTest, IsTheCoreForEveryPrebuiltType)
{
  expectCore<pcl::PointXYZ>();
  expectCore<pcl::PointXYZI>();
  expectCore<pcl::PointXYZRGB>();
  expectCore<pcl::PointNormal>();
  expectCore<pcl::PointXYZINormal>();
}

TEST_F(MultiScaleShapeFeatureTest, IndicesChooseQueriesTheSurfaceTheNeighbors)
{
  const auto cloud = wire<pcl::PointXYZ>();
  MultiScaleShapeFeature<pcl::PointXYZ> feature;
  feature.setInputCloud(cloud);
  Records all, some;
  feature.compute(all);
  const auto indices = pcl::make_shared<pcl::Indices>(pcl::Indices{250, 3, 3, 77});
  feature.setIndices(indices);
  feature.compute(some);
  ASSERT_EQ(some.size(), 4u);
  EXPECT_EQ(some.width, 4u);
  for (std::size_t i = 0; i < some.size(); ++i)
    EXPECT_TRUE(same(some[i], all[static_cast<std::size_t>((*indices)[i])]));

  // The same queries as a separate cloud, with neighbors from the whole.
  const auto queries =
      pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>(*cloud, *indices);
  MultiScaleShapeFeature<pcl::PointXYZ> other;
  other.setInputCloud(queries);
  other.setSearchSurface(cloud);
  other.setSearchMethod(pcl::make_shared<pcl::search::KdTree<pcl::PointXYZ>>());
  Records out;
  other.compute(out);
  ASSERT_EQ(out.size(), 4u);
  for (std::size_t i = 0; i < out.size(); ++i)
    EXPECT_TRUE(same(out[i], some[i]));
}

TEST_F(MultiScaleShapeFeatureTest, QueryThatIsNotFinite)
{
  auto cloud = wire<pcl::PointXYZ>();
  Records clean, out;
  MultiScaleShapeFeature<pcl::PointXYZ> feature;
  feature.setInputCloud(cloud);
  feature.setRadii({0.2, 0.5, 1.5});
  feature.compute(clean);
  auto broken = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>(*cloud);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  broken->emplace_back(nan, 0.F, 0.F);
  broken->is_dense = false;
  broken->header.stamp = 17;
  feature.setInputCloud(broken);
  feature.compute(out);
  ASSERT_EQ(out.size(), cloud->size() + 1);
  EXPECT_FALSE(out.is_dense);
  EXPECT_EQ(out.header.stamp, 17u);
  EXPECT_TRUE(std::isnan(out.back().linearity));
  EXPECT_EQ(out.back().neighbors, 0u);
  EXPECT_EQ(out.back().scale, -1);
  for (std::size_t i = 0; i < cloud->size(); ++i)
    EXPECT_TRUE(same(out[i], clean[i]));
}

TEST_F(MultiScaleShapeFeatureTest, SearchRadiusIsTheLargestRadius)
{
  MultiScaleShapeFeature<pcl::PointXYZ> feature;
  feature.setInputCloud(wire<pcl::PointXYZ>());
  feature.setRadiusSearch(2);
  Records out;
  feature.compute(out);
  EXPECT_EQ(out.size(), 300u);
  EXPECT_LE(feature.getRadii().back(), 2);
  EXPECT_GT(feature.getRadii().back(), 2 / 1.5);
}

TEST_F(MultiScaleShapeFeatureTest, GraphsAreOptionalAndCanBeStreamed)
{
  MultiScaleShapeFeature<pcl::PointXYZ> feature;
  feature.setInputCloud(wire<pcl::PointXYZ>());
  Records out;
  feature.compute(out);
  const std::vector<ShapeGraph> kept = feature.getGraphs();
  feature.setKeepGraphs(false);
  std::size_t next = 0;
  feature.setGraphSink([&](std::size_t query, const ShapeGraph& graph) {
    ASSERT_EQ(query, next++);
    ASSERT_EQ(graph.size(), kept[query].size());
    EXPECT_EQ(graph.back().linearity, kept[query].back().linearity);
  });
  feature.compute(out);
  EXPECT_EQ(next, 300u);
  EXPECT_TRUE(feature.getGraphs().empty());
}

TEST_F(MultiScaleShapeFeatureTest, NoiseRateNeedsTheQueryPointAsCentroid)
{
  MultiScaleShapeFeature<pcl::PointXYZ> feature;
  feature.setInputCloud(wire<pcl::PointXYZ>());
  feature.setCentroid(Centroid::Mean);
  Records out;
  feature.compute(out);
  EXPECT_EQ(out.size(), 300u);
  EXPECT_TRUE(std::isnan(feature.getNoiseRate()));
  EXPECT_TRUE(std::isnan(feature.getNoiseWidth()));
}

TEST_F(MultiScaleShapeFeatureTest, RefusesInvalidSettings)
{
  const auto cloud = wire<pcl::PointXYZ>();
  const auto refused = [&](auto change) {
    MultiScaleShapeFeature<pcl::PointXYZ> feature;
    feature.setInputCloud(cloud);
    change(feature);
    Records out;
    out.resize(5);
    feature.compute(out);
    return out.empty() && feature.getRadii().empty();
  };
  EXPECT_FALSE(refused([](auto&) {}));
  EXPECT_TRUE(refused([](auto& feature) { feature.setInputCloud(nullptr); }));
  EXPECT_TRUE(refused([](auto& feature) {
    feature.setInputCloud(pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>());
  }));
  EXPECT_TRUE(refused([](auto& feature) { feature.setKSearch(5); }));
  EXPECT_TRUE(refused([](auto& feature) { feature.setRadiusSearch(-1); }));
  EXPECT_TRUE(refused([](auto& feature) { feature.setMaxRadius(1e-9); }));
  EXPECT_TRUE(refused([](auto& feature) { feature.setRadii({2, 1}); }));
  EXPECT_TRUE(refused([](auto& feature) {
    feature.setRadiusSearch(1);
    feature.setMaxRadius(1);
  }));
  EXPECT_TRUE(refused([](auto& feature) {
    feature.setIndices(pcl::make_shared<pcl::Indices>(pcl::Indices{0, 300}));
  }));
  EXPECT_TRUE(refused([](auto& feature) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const auto nothing = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
    nothing->emplace_back(nan, nan, nan);
    feature.setSearchSurface(nothing);
  }));
}

TEST_F(MultiScaleShapeFeatureTest, NoIndicesNoRecords)
{
  MultiScaleShapeFeature<pcl::PointXYZ> feature;
  feature.setInputCloud(wire<pcl::PointXYZ>());
  feature.setIndices(pcl::make_shared<pcl::Indices>());
  Records out;
  feature.compute(out);
  EXPECT_TRUE(out.empty());
}

TEST_F(MultiScaleShapeFeatureTest, RadiiGrowAsRequested)
{
  MultiScaleShapeFeature<pcl::PointXYZ> feature;
  feature.setInputCloud(wire<pcl::PointXYZ>());
  Records out;
  feature.compute(out);
  const double unit = feature.getScaleUnit();
  ASSERT_GT(unit, 0);
  EXPECT_NEAR(feature.getRadii()[1], 1.5 * unit, 1e-9 * unit);
  feature.setGrowth(RadiusGrowth::Linear);
  feature.setMaxRadius(10.5 * unit);
  EXPECT_EQ(feature.getGrowth(), RadiusGrowth::Linear);
  EXPECT_EQ(feature.getMaxRadius(), 10.5 * unit);
  feature.compute(out);
  ASSERT_EQ(feature.getRadii().size(), 10u);
  for (std::size_t k = 0; k < 10; ++k)
    EXPECT_NEAR(feature.getRadii()[k], static_cast<double>(k + 1) * unit, 1e-9 * unit);
}

TEST_F(MultiScaleShapeFeatureTest, RecordsAreAPointTypeOfPcl)
{
  MultiScaleShapeFeature<pcl::PointXYZ> feature;
  feature.setInputCloud(wire<pcl::PointXYZ>());
  Records out, back;
  feature.compute(out);
  pcl::PCLPointCloud2 blob;
  pcl::toPCLPointCloud2(out, blob);
  const std::vector<std::string> names = {"linearity",
                                          "planarity",
                                          "sphericity",
                                          "optimal_radius",
                                          "blend",
                                          "linearity_sum",
                                          "linearity_max",
                                          "min_sphericity",
                                          "major_x",
                                          "major_y",
                                          "major_z",
                                          "neighbors",
                                          "first_neighbors",
                                          "scale"};
  ASSERT_EQ(blob.fields.size(), names.size());
  for (std::size_t i = 0; i < names.size(); ++i)
    EXPECT_EQ(blob.fields[i].name, names[i]);
  pcl::fromPCLPointCloud2(blob, back);
  ASSERT_EQ(back.size(), out.size());
  for (std::size_t i = 0; i < out.size(); ++i)
    EXPECT_TRUE(same(out[i], back[i]));
}

} // namespace

TEST_F(MultiScaleShapeFeatureTest, NeighborsComeFromTheSearchThatWasGiven)
{
  const auto cloud = test::depthImage();
  const Points points = pointsOf(*cloud);
  // The same neighbors in the same order: equal to the last bit.
  const MultiScaleShapes expected = multiScaleShapes(KdTree(points), points, points);
  const auto built_in = multiScaleShapes(points, points);
  for (const auto& [name, search] : test::searches(true)) {
    if (!search)
      continue;
    SCOPED_TRACE(name);
    MultiScaleShapeFeature<pcl::PointXYZ> feature;
    feature.setInputCloud(cloud);
    feature.setSearchMethod(search);
    Records out;
    feature.compute(out);
    EXPECT_EQ(search->getInputCloud(), cloud) << "the search was not used";
    EXPECT_EQ(feature.getScaleUnit(), expected.scale_unit);
    EXPECT_EQ(feature.getRadii(), expected.radii);
    ASSERT_EQ(out.size(), points.size());
    for (std::size_t i = 0; i < out.size(); ++i) {
      ASSERT_TRUE(same(out[i], expected.shapes[i])) << "point " << i;
      ASSERT_EQ(out[i].first_neighbors, built_in.shapes[i].first_neighbors);
      if (!std::isnan(out[i].linearity_sum)) {
        ASSERT_NEAR(out[i].linearity_sum, built_in.shapes[i].linearity_sum, 2e-3);
      }
    }
  }
}

TEST_F(MultiScaleShapeFeatureTest, AnEngineOfItsOwnLeavesTheSearchAside)
{
  const auto search = pcl::make_shared<pcl::search::KdTree<pcl::PointXYZ>>();
  MultiScaleShapeFeature<pcl::PointXYZ> feature;
  feature.setInputCloud(wire<pcl::PointXYZ>());
  MultiScaleSettings settings;
  settings.engine = ScaleEngine::Sweep;
  feature.setSettings(settings);
  Records without, with;
  feature.compute(without);
  feature.setSearchMethod(search);
  feature.compute(with);
  for (std::size_t i = 0; i < with.size(); ++i)
    EXPECT_TRUE(same(with[i], without[i]));
}

TEST_F(MultiScaleShapeFeatureTest, TheStopRuleAsksTheGivenSearchToo)
{
  const auto cloud = wire<pcl::PointXYZ>();
  MultiScaleSettings settings;
  settings.centroid = Centroid::Mean;
  settings.stop_change = 0.02;
  MultiScaleShapeFeature<pcl::PointXYZ> feature;
  feature.setInputCloud(cloud);
  feature.setSettings(settings);
  Records out;
  feature.compute(out);
  const std::vector<double> expected = feature.getRadii();
  feature.setSearchMethod(pcl::make_shared<pcl::search::Octree<pcl::PointXYZ>>(0.3));
  feature.compute(out);
  EXPECT_EQ(feature.getRadii(), expected);
}
