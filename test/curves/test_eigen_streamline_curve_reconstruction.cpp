// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <limits>

#include <gtest/gtest.h>

#include <pcl/console/print.h>
#include <pcl/conversions.h>

#include <bench/geometries/test_cloud.h>
#include <bench/measures/measures.h>
#include <linelet/curves/eigen_streamline_curve_reconstruction.h>
#include <linelet/search/kd_tree.h>
#include <linelet/search/pcl_search.h>

#include "features/pdt_fixture.h"

using namespace linelet;
using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Reconstruction = EigenStreamlineCurveReconstruction<pcl::PointXYZ>;

namespace {

Cloud::Ptr
cloudOf(bench::Geometry geometry)
{
  auto cloud = pcl::make_shared<Cloud>();
  for (const Point& p : bench::sample(geometry, {}))
    cloud->emplace_back(float(p.x()), float(p.y()), float(p.z()));
  cloud->header.frame_id = "map";
  return cloud;
}

class CurveReconstructionInPcl : public ::testing::TestWithParam<Preset> {
protected:
  void
  SetUp() override
  {
    pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
    reconstruction.setPreset(GetParam());
  }

  Reconstruction reconstruction;
};

} // namespace

TEST_P(CurveReconstructionInPcl, FindsTheCurve)
{
  reconstruction.setInputCloud(cloudOf(bench::Geometry::Helix));
  EXPECT_TRUE(bench::measure(reconstruction.reconstruct(),
                             bench::truthOf(bench::Geometry::Helix))
                  .success);
}

TEST_P(CurveReconstructionInPcl, MeshAndVerticesAreTheCurves)
{
  const auto cloud = cloudOf(bench::Geometry::Circle);
  reconstruction.setInputCloud(cloud);
  const CurveNetwork curves = reconstruction.reconstruct();
  ASSERT_EQ(curves.curves.size(), 1u);
  ASSERT_TRUE(curves.curves[0].closed);

  // Through the base class, as PCL code would do.
  pcl::SurfaceReconstruction<pcl::PointXYZ>& base = reconstruction;
  pcl::PolygonMesh mesh;
  mesh.polygons.resize(7); // leftovers of the caller
  base.reconstruct(mesh);
  Cloud points;
  std::vector<pcl::Vertices> polygons(3);
  base.reconstruct(points, polygons);

  Cloud mesh_points;
  pcl::fromPCLPointCloud2(mesh.cloud, mesh_points);
  ASSERT_EQ(polygons.size(), 1u);
  ASSERT_EQ(mesh.polygons.size(), 1u);
  EXPECT_EQ(mesh.polygons[0].vertices, polygons[0].vertices);
  EXPECT_EQ(mesh.header.frame_id, "map");
  EXPECT_EQ(points.header.frame_id, "map");
  const std::size_t count = curves.curves[0].points.size();
  ASSERT_EQ(points.size(), count);
  ASSERT_EQ(mesh_points.size(), count);
  ASSERT_EQ(polygons[0].vertices.size(), count + 1) << "a closed curve comes back";
  EXPECT_EQ(polygons[0].vertices.back(), polygons[0].vertices.front());
  for (std::size_t i = 0; i < count; ++i) {
    EXPECT_EQ(points[i].x, float(curves.curves[0].points[i].x()));
    EXPECT_EQ(mesh_points[i].y, float(curves.curves[0].points[i].y()));
  }
}

TEST_P(CurveReconstructionInPcl, WithoutInputTheResultIsEmpty)
{
  EXPECT_TRUE(reconstruction.reconstruct().curves.empty());
  pcl::PolygonMesh mesh;
  mesh.polygons.resize(2);
  reconstruction.reconstruct(mesh);
  EXPECT_TRUE(mesh.polygons.empty());
  Cloud points;
  std::vector<pcl::Vertices> polygons(2);
  reconstruction.reconstruct(points, polygons);
  EXPECT_TRUE(points.empty());
  EXPECT_TRUE(polygons.empty());
}

TEST_P(CurveReconstructionInPcl, EmptyAndUnusableCloudsGiveNoCurve)
{
  const float nan = std::numeric_limits<float>::quiet_NaN();
  auto cloud = pcl::make_shared<Cloud>();
  reconstruction.setInputCloud(cloud);
  EXPECT_TRUE(reconstruction.reconstruct().curves.empty());
  for (const pcl::PointXYZ& point :
       {pcl::PointXYZ(1, 2, 3), pcl::PointXYZ(nan, nan, nan)}) {
    auto repeated = pcl::make_shared<Cloud>();
    repeated->resize(100, point);
    repeated->is_dense = false;
    reconstruction.setInputCloud(repeated);
    EXPECT_TRUE(reconstruction.reconstruct().curves.empty());
  }
}

TEST_P(CurveReconstructionInPcl, IndicesChooseThePoints)
{
  auto both = cloudOf(bench::Geometry::Line);
  const std::size_t line = both->size();
  const auto circle = cloudOf(bench::Geometry::Circle);
  for (const auto& point : *circle)
    both->emplace_back(point.x, point.y, point.z + 50);
  both->emplace_back(std::numeric_limits<float>::quiet_NaN(), 0.F, 0.F);
  both->is_dense = false;
  auto indices = pcl::make_shared<pcl::Indices>();
  for (std::size_t i = line; i < both->size(); ++i)
    indices->push_back(static_cast<pcl::index_t>(i));
  reconstruction.setInputCloud(both);
  reconstruction.setIndices(indices);
  const CurveNetwork curves = reconstruction.reconstruct();
  ASSERT_EQ(curves.curves.size(), 1u);
  for (const Point& p : curves.curves[0].points)
    EXPECT_NEAR(p.z(), 50, 0.1);

  indices->push_back(static_cast<pcl::index_t>(both->size()));
  EXPECT_TRUE(reconstruction.reconstruct().curves.empty()) << "no such point";
}

TEST_P(CurveReconstructionInPcl, ParametersOutOfRangeGiveAnEmptyResult)
{
  reconstruction.setInputCloud(cloudOf(bench::Geometry::Line));
  reconstruction.setDistanceCutoff(-1);
  EXPECT_TRUE(reconstruction.reconstruct().curves.empty());
}

TEST_P(CurveReconstructionInPcl, NeighborsComeFromTheSearchThatWasGiven)
{
  const auto image = test::depthImage(); // organized, with holes
  const auto helix = cloudOf(bench::Geometry::Helix);
  ReconstructionSettings settings = reconstruction.getSettings();
  for (const auto& cloud : {image, helix}) {
    const Points points = pointsOf(*cloud);
    const CurveNetwork expected = reconstructCurves(KdTree(points), points, settings);
    ASSERT_FALSE(expected.curves.empty());
    EXPECT_NEAR(length(reconstructCurves(points, settings)),
                length(expected),
                0.02 * length(expected))
        << "with the search built in, up to the order of sums";
    for (const auto& [name, search] : test::searches(cloud->isOrganized())) {
      if (!search)
        continue;
      SCOPED_TRACE(name);
      reconstruction.setInputCloud(cloud);
      reconstruction.setSearchMethod(search);
      const CurveNetwork curves = reconstruction.reconstruct();
      EXPECT_EQ(search->getInputCloud(), cloud) << "the search was not used";
      ASSERT_EQ(curves.curves.size(), expected.curves.size());
      for (std::size_t i = 0; i < curves.curves.size(); ++i)
        EXPECT_EQ(curves.curves[i].points, expected.curves[i].points);
    }
  }
}

TEST_P(CurveReconstructionInPcl, AGivenSearchServesIndicesAndMovedPointsToo)
{
  const auto cloud = cloudOf(bench::Geometry::Helix);
  for (std::size_t i = 0; i < 256; ++i)
    cloud->emplace_back(0, 0, 50 + 0.01F * static_cast<float>(i));
  Points half;
  auto indices = pcl::make_shared<pcl::Indices>();
  for (int i = 0; i < 256; ++i) {
    indices->push_back(i);
    half.push_back(
        cloud->at(static_cast<std::size_t>(i)).getVector3fMap().cast<double>());
  }
  ReconstructionSettings settings = reconstruction.getSettings();
  settings.prefilter.radius = 0.2;
  reconstruction.setSettings(settings);
  reconstruction.setInputCloud(cloud);
  reconstruction.setIndices(indices);
  reconstruction.setSearchMethod(
      pcl::make_shared<pcl::search::Octree<pcl::PointXYZ>>(0.5));
  const CurveNetwork curves = reconstruction.reconstruct();
  const CurveNetwork expected = reconstructCurves(half, settings);
  ASSERT_FALSE(curves.curves.empty());
  EXPECT_NEAR(length(curves), length(expected), 1e-3 * length(expected));
}

TEST(CurveReconstructionSetters, SetWhatTheyName)
{
  Reconstruction reconstruction;
  reconstruction.setStartPoints(3);
  reconstruction.setMaxIterations(7);
  reconstruction.setDistanceCutoff(0.5);
  reconstruction.setPreset(Preset::Published);
  reconstruction.setNumberOfThreads(2);
  const ReconstructionSettings& settings = reconstruction.getSettings();
  EXPECT_EQ(settings.start_points, 3u);
  EXPECT_EQ(settings.max_iterations, 7u);
  EXPECT_EQ(settings.distance_cutoff, 0.5);
  EXPECT_EQ(settings.preset, Preset::Published);
  EXPECT_EQ(settings.threads, 2u);
  EXPECT_EQ(reconstruction.getStartPoints(), 3u);
  EXPECT_EQ(reconstruction.getMaxIterations(), 7u);
  EXPECT_EQ(reconstruction.getDistanceCutoff(), 0.5);
  EXPECT_EQ(reconstruction.getPreset(), Preset::Published);
  EXPECT_EQ(reconstruction.getNumberOfThreads(), 2u);
}

INSTANTIATE_TEST_SUITE_P(Presets,
                         CurveReconstructionInPcl,
                         ::testing::Values(Preset::Refined, Preset::Published),
                         [](const auto& info) {
                           return std::string(nameOf(info.param));
                         });
