// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/features/point_distribution_tensor.h>
#ifdef PCL_NO_PRECOMPILE
#error "a public header must not switch off PCL's prebuilt templates"
#endif

#include <cmath>
#include <cstring>
#include <limits>
#include <string>

#include <pcl/conversions.h>
#include <pcl/PCLPointCloud2.h>

#include "features/pdt_fixture.h"

using namespace linelet;
using namespace linelet::test;
TEST_F(PdtEstimation, MarksWhatCannotBeKnown)
{
  auto cloud = pcl::make_shared<Cloud>();
  for (int i = 0; i < 20; ++i)
    cloud->emplace_back(1.0f, 2.0f, 3.0f); // all in one place
  cloud->emplace_back(50.0f, 0.0f, 0.0f);  // alone
  for (const auto& [name, search] : searches(false)) {
    SCOPED_TRACE(name);
    Estimation estimation;
    estimation.setInputCloud(cloud);
    estimation.setSearchMethod(search);
    estimation.setRadiusSearch(1);
    RecordCloud records = compute(estimation);
    ASSERT_EQ(records.size(), 21u);
    EXPECT_FALSE(records.is_dense);
    EXPECT_TRUE(std::isnan(records[0].lambda1));
    EXPECT_EQ(records[0].neighbors, 20u);
    EXPECT_TRUE(std::isnan(records[20].xx));
    EXPECT_EQ(records[20].neighbors, 1u);
    estimation.setRadiusSearch(0);
    estimation.setKSearch(5);
    records = compute(estimation);
    EXPECT_TRUE(std::isnan(records[0].lambda1));
    EXPECT_EQ(records[20].neighbors, 5u);
    EXPECT_EQ(records[20].linearity, 1);

    // A non-finite query in a cloud that claims to be dense.
    auto query = pcl::make_shared<Cloud>();
    query->emplace_back(0.0f, not_known, 0.0f);
    Estimation other;
    other.setInputCloud(query);
    other.setSearchSurface(cloud);
    other.setSearchMethod(search);
    other.setRadiusSearch(1);
    records = compute(other);
    ASSERT_EQ(records.size(), 1u);
    EXPECT_TRUE(std::isnan(records[0].normal_x));
    EXPECT_EQ(records[0].neighbors, 0u);
    EXPECT_FALSE(records.is_dense);
  }
}

TEST_F(PdtEstimation, IsDenseWhereEverythingIsKnown)
{
  const Cloud::Ptr cloud = scattered(500, 8);
  cloud->is_dense = false; // the input's flag must not affect the output
  cloud->header.frame_id = "lidar";
  cloud->header.stamp = 77;
  Estimation estimation;
  estimation.setInputCloud(cloud);
  estimation.setKSearch(8);
  const RecordCloud records = compute(estimation);
  EXPECT_TRUE(records.is_dense);
  EXPECT_EQ(records.header.frame_id, "lidar");
  EXPECT_EQ(records.header.stamp, 77u);
}

TEST_F(PdtEstimation, RefusesInputThatMakesNoSense)
{
  const Cloud::Ptr cloud = scattered(50, 1);
  const double infinite = std::numeric_limits<double>::infinity();
  for (const auto& [name, search] : searches(false)) {
    SCOPED_TRACE(name);
    const auto size = [&](auto prepare) {
      Estimation estimation;
      estimation.setInputCloud(cloud);
      estimation.setSearchMethod(search);
      prepare(estimation);
      RecordCloud records(3, 1);
      estimation.compute(records);
      return records.size();
    };
    EXPECT_EQ(size([](Estimation& e) { e.setRadiusSearch(1); }), 50u);
    EXPECT_EQ(size([](Estimation&) {}), 0u); // neither radius nor k
    EXPECT_EQ(size([](Estimation& e) { e.setRadiusSearch(1), e.setKSearch(5); }), 0u);
    EXPECT_EQ(size([](Estimation& e) { e.setRadiusSearch(-1); }), 0u);
    EXPECT_EQ(size([](Estimation& e) { e.setKSearch(-5); }), 0u);
    EXPECT_EQ(size([&](Estimation& e) { e.setRadiusSearch(infinite); }), 0u);
    EXPECT_EQ(size([](Estimation& e) { e.setRadiusSearch(not_known); }), 0u);
    for (const int index : {-1, 50}) {
      EXPECT_EQ(size([&](Estimation& e) {
                  e.setRadiusSearch(1);
                  e.setIndices(pcl::make_shared<pcl::Indices>(pcl::Indices{0, index}));
                }),
                0u);
    }
    EXPECT_EQ(size([](Estimation& e) {
                e.setRadiusSearch(1);
                e.setIndices(pcl::make_shared<pcl::Indices>());
              }),
              0u);
    for (const Cloud::Ptr& empty :
         {pcl::make_shared<Cloud>(),
          pcl::make_shared<Cloud>(5, 1, pcl::PointXYZ(not_known, 0, 0))}) {
      EXPECT_EQ(size([&](Estimation& e) {
                  e.setRadiusSearch(1);
                  e.setInputCloud(empty);
                }),
                0u);
      EXPECT_EQ(size([&](Estimation& e) {
                  e.setRadiusSearch(1);
                  e.setSearchSurface(empty);
                }),
                0u);
    }
  }
  Estimation none;
  none.setRadiusSearch(1);
  EXPECT_TRUE(compute(none).empty());
}

TEST_F(PdtEstimation, SeesACloudAlteredInPlaceWithoutASearchOfItsOwn)
{
  // PCL's features keep the tree of the first computation.
  const Cloud::Ptr cloud = scattered(200, 9);
  Estimation estimation;
  estimation.setInputCloud(cloud);
  estimation.setRadiusSearch(0.8);
  compute(estimation);
  *cloud = *scattered(200, 10);
  const RecordCloud again = compute(estimation);
  Estimation fresh;
  fresh.setInputCloud(cloud);
  fresh.setRadiusSearch(0.8);
  expectSame(again, compute(fresh));
}

TEST_F(PdtEstimation, GivesTheSameBitsForAnyNumberOfThreads)
{
  const Cloud::Ptr cloud = scattered(1200, 11);
  for (const auto& [name, search] : searches(false)) {
    SCOPED_TRACE(name);
    Estimation estimation;
    estimation.setInputCloud(cloud);
    estimation.setSearchMethod(search);
    estimation.setRadiusSearch(0.5);
    estimation.setCentroid(Centroid::WeightedMedian);
    estimation.setNumberOfThreads(1);
    const RecordCloud serial = compute(estimation);
    for (const unsigned threads : {4u, 0u}) {
      estimation.setNumberOfThreads(threads);
      const RecordCloud parallel = compute(estimation);
      ASSERT_EQ(serial.size(), parallel.size());
      EXPECT_EQ(std::memcmp(serial.points.data(),
                            parallel.points.data(),
                            serial.size() * sizeof(serial[0])),
                0);
    }
  }
}

TEST_F(PdtEstimation, GettersMirrorSetters)
{
  Estimation estimation;
  EXPECT_EQ(estimation.getWeighting(), Weighting(Kernel::FermiDirac1));
  EXPECT_EQ(estimation.getCentroid(), Centroid::QueryPoint);
  estimation.setWeighting(Weighting::fermiDirac(0.6, 0.1));
  estimation.setCentroid(Centroid::WeightedMean);
  estimation.setCentroidWeighting(Weighting("quadratic"));
  estimation.setEngine(Engine::Tree);
  estimation.setNumberOfThreads(3);
  EXPECT_EQ(estimation.getWeighting().name(), "fermi-dirac:0.6,0.1");
  EXPECT_EQ(estimation.getCentroid(), Centroid::WeightedMean);
  EXPECT_EQ(estimation.getCentroidWeighting().name(), "quadratic");
  EXPECT_EQ(estimation.getEngine(), Engine::Tree);
  EXPECT_EQ(estimation.getNumberOfThreads(), 3u);
}

TEST_F(PdtEstimation, SettingsAtOnceAreThoseOneByOne)
{
  const Cloud::Ptr cloud = scattered(300, 5);
  TensorSettings settings;
  settings.radius = 0.6;
  settings.weighting = Kernel::Quadratic;
  settings.centroid = Centroid::Mean;
  Estimation estimation;
  estimation.setInputCloud(cloud);
  estimation.setKSearch(9); // replaced by the radius
  estimation.setSettings(settings);
  EXPECT_EQ(estimation.getSettings().radius, 0.6);
  EXPECT_EQ(estimation.getSettings().k, 0u);
  EXPECT_EQ(estimation.getRadiusSearch(), 0.6);
  expectSame(compute(estimation), reference(*cloud, *cloud, settings), 1e-5f);
}

TEST_F(PdtEstimation, IsCanceledByItsMonitorAndWorksAgain)
{
  class Impatient : public ProgressMonitor {
  public:
    bool
    canceled() const override
    {
      return stop;
    }
    bool stop = true;
  } monitor;
  Estimation estimation;
  estimation.setInputCloud(scattered(2000, 6));
  estimation.setRadiusSearch(0.5);
  estimation.setProgressMonitor(&monitor);
  RecordCloud records;
  EXPECT_THROW(estimation.compute(records), Canceled);
  // Neither the stop nor the previous cloud remains.
  monitor.stop = false;
  const Cloud::Ptr other = scattered(100, 7);
  estimation.setInputCloud(other);
  TensorSettings settings;
  settings.radius = 0.5;
  expectSame(compute(estimation), reference(*other, *other, settings), 1e-5f);
}

TEST_F(PdtEstimation, RecordIsAPointTypeWithTheseFields)
{
  pcl::PCLPointCloud2 message;
  pcl::toPCLPointCloud2(RecordCloud(2, 1), message);
  std::string names;
  for (const pcl::PCLPointField& field : message.fields) {
    names += field.name + " ";
    EXPECT_EQ(field.count, 1u);
  }
  EXPECT_EQ(
      names,
      "xx xy xz yy yz zz lambda1 lambda2 lambda3 major_x major_y major_z normal_x "
      "normal_y normal_z linearity planarity sphericity neighbors ");
}

namespace {

template <class PointT>
class PrebuiltTypes : public testing::Test {
};

using Prebuilt = testing::Types<pcl::PointXYZ,
                                pcl::PointXYZI,
                                pcl::PointXYZRGB,
                                pcl::PointNormal,
                                pcl::PointXYZINormal>;
TYPED_TEST_SUITE(PrebuiltTypes, Prebuilt);

} // namespace

TYPED_TEST(PrebuiltTypes, GiveTheSame)
{
  const Cloud::Ptr plain = scattered(200, 12);
  auto cloud = pcl::make_shared<pcl::PointCloud<TypeParam>>();
  for (const pcl::PointXYZ& point : *plain) {
    TypeParam other;
    other.x = point.x;
    other.y = point.y;
    other.z = point.z;
    cloud->push_back(other);
  }
  TensorSettings settings;
  settings.radius = 0.7;
  PointDistributionTensorEstimation<TypeParam> estimation;
  estimation.setInputCloud(cloud);
  estimation.setRadiusSearch(0.7);
  RecordCloud records;
  estimation.compute(records);
  expectSame(records, reference(*plain, *plain, settings), 1e-5f);
}
