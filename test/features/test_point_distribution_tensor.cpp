// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <linelet/features/point_distribution_tensor.h>
#ifdef PCL_NO_PRECOMPILE
#error "a public header must not switch off PCL's prebuilt templates"
#endif

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <gtest/gtest.h>

#include <pcl/console/print.h>
#include <pcl/conversions.h>
#include <pcl/PCLPointCloud2.h>
#include <pcl/search/brute_force.h>
#include <pcl/search/kdtree.h>
#include <pcl/search/octree.h>
#include <pcl/search/organized.h>

#include <linelet/search/pcl_search.h>

using namespace linelet;

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Estimation = PointDistributionTensorEstimation<pcl::PointXYZ>;
using Records = pcl::PointCloud<PointDistributionTensor>;
using SearchPtr = pcl::search::Search<pcl::PointXYZ>::Ptr;

constexpr float not_known = std::numeric_limits<float>::quiet_NaN();

/** \brief A curved surface and a wire as a depth camera sees them, with holes. */
Cloud::Ptr
depthImage()
{
  boost::random::mt19937 random(4);
  boost::random::normal_distribution<float> normal;
  auto cloud = pcl::make_shared<Cloud>(56, 42);
  for (unsigned row = 0; row < 42; ++row) {
    for (unsigned column = 0; column < 56; ++column) {
      const float x = (static_cast<float>(column) - 27.5f) / 50;
      const float y = (static_cast<float>(row) - 20.5f) / 50;
      const float depth =
          (row == 15 ? 1.5f : 2 + x * x + 0.3f * y) + 0.002f * normal(random);
      auto& point = cloud->at(column, row);
      point.x = x * depth;
      point.y = y * depth;
      point.z = depth;
      if ((column * 7 + row * 13) % 31 == 0)
        point.x = point.y = point.z = not_known;
    }
  }
  cloud->is_dense = false;
  return cloud;
}

/** \brief Multiples of 1/32, which float still holds at 5e5. */
Cloud::Ptr
scattered(std::size_t count, unsigned seed, float offset = 0)
{
  boost::random::mt19937 random(seed);
  boost::random::normal_distribution<double> normal;
  auto cloud = pcl::make_shared<Cloud>();
  const auto step = [&](double size) {
    return offset + static_cast<float>(std::round(32 * size * normal(random)) / 32);
  };
  for (std::size_t i = 0; i < count; ++i) {
    const float x = step(2), y = step(i % 2 == 0 ? 0.1 : 1);
    cloud->emplace_back(x, y, step(0.5));
  }
  return cloud;
}

std::vector<std::pair<std::string, SearchPtr>>
searches(bool organized)
{
  using Point = pcl::PointXYZ;
  std::vector<std::pair<std::string, SearchPtr>> all = {
      {"built in", nullptr},
      {"kd-tree", pcl::make_shared<pcl::search::KdTree<Point>>()},
      {"kd-tree, unsorted", pcl::make_shared<pcl::search::KdTree<Point>>(false)},
      {"octree", pcl::make_shared<pcl::search::Octree<Point>>(0.25)},
      {"brute force", pcl::make_shared<pcl::search::BruteForce<Point>>()},
  };
  if (organized)
    all.emplace_back("organized",
                     pcl::make_shared<pcl::search::OrganizedNeighbor<Point>>());
  return all;
}

Records
compute(Estimation& estimation)
{
  Records records;
  estimation.compute(records);
  return records;
}

void
expectSame(const Records& a, const Records& b, float tolerance = 0)
{
  ASSERT_EQ(a.size(), b.size());
  EXPECT_EQ(a.is_dense, b.is_dense);
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_EQ(a[i].neighbors, b[i].neighbors) << "query " << i;
    ASSERT_EQ(std::isnan(a[i].linearity), std::isnan(b[i].linearity)) << "query " << i;
    if (std::isnan(a[i].linearity))
      continue;
    ASSERT_NEAR(a[i].linearity, b[i].linearity, tolerance) << "query " << i;
    ASSERT_NEAR(a[i].planarity, b[i].planarity, tolerance) << "query " << i;
    ASSERT_NEAR(a[i].sphericity, b[i].sphericity, tolerance) << "query " << i;
  }
}

/** \brief What the core gives for the points of a cloud. */
Records
reference(const Cloud& surface, const Cloud& queries, const TensorSettings& settings)
{
  Records records;
  records.is_dense = true;
  for (const PointDistributionTensor& record :
       estimateTensors(pointsOf(surface), pointsOf(queries), settings)) {
    records.push_back(record);
    records.is_dense = records.is_dense && !std::isnan(record.linearity);
  }
  return records;
}

class PdtEstimation : public testing::Test {
protected:
  void
  SetUp() override
  {
    pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS); // refusals are wanted here
  }
};

} // namespace

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
      const Records expected = reference(*cloud, *cloud, settings);
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
        const Records records = compute(estimation);
        // The same neighbours in the same order give the same bits; the built-in grid
        // may add them up in another one.
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
  settings.radius = 0.75; // many points lie at exactly this distance
  settings.engine = Engine::Tree;
  const Records expected = reference(*here, *here, settings);
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
  // In float the two small eigenvalues of a 1 cm wire would be off by more than 100 %.
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
  const Records records = compute(estimation);
  ASSERT_EQ(records.size(), 1u);
  EXPECT_EQ(records[0].neighbors, 401u);
  // The wire's own axis mixes with its cross-section by no more than 1 % here.
  EXPECT_NEAR(records[0].lambda1 + records[0].lambda2, yy + zz, 0.01 * (yy + zz));
  EXPECT_NEAR(
      records[0].lambda1 * records[0].lambda2, yy * zz - yz * yz, 0.02 * (yy * zz));
  EXPECT_GT(records[0].linearity, 0.99f);
}

TEST_F(PdtEstimation, HonoursIndicesAndSearchSurface)
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
    const Records records = compute(estimation);
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
    const Records records = compute(estimation);
    ASSERT_EQ(records.size(), 3u);
    EXPECT_FALSE(records.is_dense);
    EXPECT_TRUE(std::isnan(records[0].linearity));
    estimation.setRadii({});
    for (std::size_t i = 1; i < 3; ++i) {
      const auto index = static_cast<std::size_t>((*indices)[i]);
      estimation.setRadiusSearch(radii[index]);
      const Records one = compute(estimation);
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
    Records records = compute(estimation);
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

    // A query that is not finite, in a cloud that claims to be dense.
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
  cloud->is_dense = false; // that of the input says nothing of the output
  cloud->header.frame_id = "lidar";
  cloud->header.stamp = 77;
  Estimation estimation;
  estimation.setInputCloud(cloud);
  estimation.setKSearch(8);
  const Records records = compute(estimation);
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
      Records records(3, 1);
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
  const Records again = compute(estimation);
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
    const Records serial = compute(estimation);
    for (const unsigned threads : {4u, 0u}) {
      estimation.setNumberOfThreads(threads);
      const Records parallel = compute(estimation);
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

TEST_F(PdtEstimation, RecordIsAPointTypeWithTheseFields)
{
  pcl::PCLPointCloud2 message;
  pcl::toPCLPointCloud2(Records(2, 1), message);
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
  Records records;
  estimation.compute(records);
  expectSame(records, reference(*plain, *plain, settings), 1e-5f);
}
