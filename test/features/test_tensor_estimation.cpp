// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <linelet/features/tensor_estimation.h>

using namespace linelet;

namespace {

using Records = std::vector<PointDistributionTensor>;

constexpr double not_known = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

/** \brief A wire, a patch of ground and a bush, on a lattice of 1/256 so that sums with
 * large offsets are exact. */
Points
scene(std::size_t count, unsigned seed)
{
  boost::random::mt19937 random(seed);
  boost::random::normal_distribution<double> normal;
  Points points;
  for (std::size_t i = 0; i < count; ++i) {
    const double a = normal(random), b = normal(random), c = normal(random);
    const Point point = i % 3 == 0   ? Point(2 * a, 0.02 * b, 3 + 0.02 * c)
                        : i % 3 == 1 ? Point(2 * a, 2 * b, 0.05 * c)
                                     : Point(1 + a, 1 + b, 1 + c);
    points.push_back((256 * point).array().round().matrix() / 256);
  }
  return points;
}

TensorSettings
withRadius(double radius,
           const Weighting& weighting = Kernel::FermiDirac1,
           Centroid centroid = Centroid::QueryPoint)
{
  TensorSettings settings;
  settings.radius = radius;
  settings.weighting = weighting;
  settings.centroid = centroid;
  return settings;
}

/** \brief The fixed point of Weiszfeld's iteration from the mean by patience alone. */
Point
patientMedian(const Points& points, double radius, const Weighting& weighting)
{
  Point x = Point::Zero();
  for (const Point& point : points)
    x += point / static_cast<double>(points.size());
  for (int i = 0; i < 30000; ++i) {
    const Point before = x;
    Point sum = Point::Zero();
    double total = 0;
    for (const Point& point : points) {
      const double distance = std::max((point - x).norm(), 1e-12);
      const double weight = weighting(distance / radius) / distance;
      sum += weight * point;
      total += weight;
    }
    if (!(total > 0))
      break;
    x = sum / total;
    if ((x - before).norm() < 1e-15)
      break;
  }
  return x;
}

struct Expected {
  std::size_t neighbors = 0;
  Eigen::Vector3d shape = Eigen::Vector3d::Constant(not_known);
};

/** \brief The definition, word for word. */
Expected
bruteForce(const Points& surface, const Point& p, const TensorSettings& s)
{
  Points found;
  for (const Point& point : surface)
    if ((point - p).squaredNorm() <= s.radius * s.radius)
      found.push_back(point);
  Expected expected;
  expected.neighbors = found.size();
  if (found.empty())
    return expected;

  Point c = p;
  if (s.centroid == Centroid::Mean || s.centroid == Centroid::WeightedMean) {
    const Weighting weighting =
        s.centroid == Centroid::Mean ? Weighting(Kernel::Const) : s.centroid_weighting;
    Point sum = Point::Zero();
    double total = 0;
    for (const Point& point : found) {
      const double weight = weighting((point - p).norm() / s.radius);
      sum += weight * point;
      total += weight;
    }
    c = sum / total;
  }
  else if (s.centroid != Centroid::QueryPoint)
    c = patientMedian(found,
                      s.radius,
                      s.centroid == Centroid::Median ? Weighting(Kernel::Const)
                                                     : s.centroid_weighting);

  Eigen::Matrix3d t = Eigen::Matrix3d::Zero();
  double total = 0;
  for (const Point& point : found) {
    const Point v = point - c;
    const double weight = s.weighting(v.norm() / s.radius);
    t += weight * v * v.transpose();
    total += weight;
  }
  const Eigen::Vector3d l =
      Eigen::JacobiSVD<Eigen::Matrix3d>(t / total).singularValues();
  const double sum = l.sum();
  if (total > 0 && sum > 1e-20)
    expected.shape = Eigen::Vector3d(l[0] - l[1], 2 * (l[1] - l[2]), 3 * l[2]) / sum;
  return expected;
}

double
shapeDifference(const PointDistributionTensor& record, const Eigen::Vector3d& shape)
{
  if (std::isnan(record.linearity) || std::isnan(shape[0]))
    return std::isnan(record.linearity) == std::isnan(shape[0]) ? 0 : infinite;
  return std::max({std::abs(record.linearity - shape[0]),
                   std::abs(record.planarity - shape[1]),
                   std::abs(record.sphericity - shape[2])});
}

Eigen::Vector3d
shapeOf(const PointDistributionTensor& record)
{
  return {record.linearity, record.planarity, record.sphericity};
}

Point
majorOf(const PointDistributionTensor& record)
{
  return {record.major_x, record.major_y, record.major_z};
}

Point
normalOf(const PointDistributionTensor& record)
{
  return {record.normal_x, record.normal_y, record.normal_z};
}

bool
sameBits(const Records& a, const Records& b)
{
  return a.size() == b.size() &&
         std::memcmp(a.data(), b.data(), a.size() * sizeof(a.front())) == 0;
}

PointDistributionTensor
tensorAt(const Points& surface, const Point& query, const TensorSettings& settings)
{
  return estimateTensors(surface, {query}, settings).front();
}

} // namespace

TEST(TensorEstimation, IsTheDefinitionForEveryKernelCentroidAndEngine)
{
  const Points surface = scene(700, 1);
  Points queries = scene(12, 2); // beside the cloud
  queries.insert(queries.end(), surface.begin(), surface.begin() + 12);
  std::vector<Weighting> weightings = {Weighting::fermiDirac(0.45, 0.07),
                                       Weighting::step(0.8)};
  for (const auto& entry : Names<Kernel>::table)
    if (entry.first != Kernel::FermiDirac && entry.first != Kernel::Step)
      weightings.emplace_back(entry.first);
  for (const Weighting& weighting : weightings) {
    for (const auto& [centroid, name] : Names<Centroid>::table) {
      TensorSettings settings = withRadius(0.9, weighting, centroid);
      std::vector<Expected> expected;
      for (const Point& query : queries)
        expected.push_back(bruteForce(surface, query, settings));
      for (const Engine engine : {Engine::Grid, Engine::Tree}) {
        SCOPED_TRACE(weighting.name() + " " + std::string(name) + " " +
                     std::string(nameOf(engine)));
        settings.engine = engine;
        const Records records = estimateTensors(surface, queries, settings);
        for (std::size_t i = 0; i < queries.size(); ++i) {
          EXPECT_EQ(records[i].neighbors, expected[i].neighbors);
          EXPECT_LE(shapeDifference(records[i], expected[i].shape), 1e-5)
              << "query " << i;
        }
      }
    }
  }
}

TEST(TensorEstimation, WeightedCentroidsOfEveryWeightingAreTheDefinition)
{
  const Points surface = scene(700, 3);
  const Points queries(surface.begin(), surface.begin() + 15);
  for (const char* weighting :
       {"const", "linear", "quadratic-inverse", "fermi-dirac-2", "sph-4"}) {
    for (const Centroid centroid : {Centroid::WeightedMean, Centroid::WeightedMedian}) {
      SCOPED_TRACE(std::string(weighting) + " " + std::string(nameOf(centroid)));
      TensorSettings settings = withRadius(1.1, Kernel::Const, centroid);
      settings.centroid_weighting = weighting;
      const Records records = estimateTensors(surface, queries, settings);
      for (std::size_t i = 0; i < queries.size(); ++i)
        EXPECT_LE(shapeDifference(records[i],
                                  bruteForce(surface, queries[i], settings).shape),
                  1e-5)
            << "query " << i;
    }
  }
}

TEST(TensorEstimation, OfALine)
{
  const Point direction = Point(1, 2, -2) / 3;
  Points line;
  for (int i = -50; i <= 50; ++i)
    line.push_back(0.25 * i * direction);
  const PointDistributionTensor record =
      tensorAt(line, Point::Zero(), withRadius(1.1, Kernel::Const));
  EXPECT_EQ(record.neighbors, 9u); // steps -4 .. 4
  EXPECT_FLOAT_EQ(record.linearity, 1);
  EXPECT_NEAR(record.planarity, 0, 1e-7);
  EXPECT_NEAR(record.sphericity, 0, 1e-7);
  EXPECT_FLOAT_EQ(record.lambda3, 2 * (1 + 4 + 9 + 16) * 0.0625f / 9);
  EXPECT_NEAR(std::abs(majorOf(record).dot(direction)), 1, 1e-6);
  // v (x) v / |v|^2 of a line is its direction (x) direction.
  EXPECT_NEAR(record.xy / record.lambda3, direction.x() * direction.y(), 1e-6);
  EXPECT_NEAR(record.zz / record.lambda3, direction.z() * direction.z(), 1e-6);
}

TEST(TensorEstimation, OfAPlaneAndABall)
{
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(0.7, Point(1, 2, 3).normalized()).toRotationMatrix();
  Points plane, ball;
  for (int x = -8; x <= 8; ++x)
    for (int y = -8; y <= 8; ++y) {
      plane.push_back(turn * Point(x, y, 0));
      for (int z = -8; z <= 8; ++z)
        ball.push_back(turn * Point(x, y, z));
    }
  for (const auto& [centroid, name] : Names<Centroid>::table) {
    SCOPED_TRACE(std::string(name));
    const TensorSettings settings = withRadius(6.5, Kernel::FermiDirac1, centroid);
    const PointDistributionTensor flat = tensorAt(plane, Point::Zero(), settings);
    EXPECT_NEAR(flat.planarity, 1, 1e-6);
    EXPECT_NEAR(std::abs(normalOf(flat).dot(turn.col(2))), 1, 1e-6);
    const PointDistributionTensor round = tensorAt(ball, Point::Zero(), settings);
    EXPECT_NEAR(round.sphericity, 1, 1e-6);
  }
}

TEST(TensorEstimation, OfAHelixFollowsTheTangent)
{
  Points helix;
  for (int i = 0; i <= 4000; ++i) {
    const double t = 0.001 * i * 12.566370614359172;
    helix.emplace_back(3 * std::cos(t), 3 * std::sin(t), 10 * t / 12.566370614359172);
  }
  for (const int i : {1000, 2000, 2500}) {
    const double t = 0.001 * i * 12.566370614359172;
    const Point tangent =
        Point(-3 * std::sin(t), 3 * std::cos(t), 10 / 12.566370614359172).normalized();
    const PointDistributionTensor record =
        tensorAt(helix, helix[static_cast<std::size_t>(i)], withRadius(0.3));
    EXPECT_GT(record.linearity, 0.99);
    EXPECT_GT(std::abs(majorOf(record).dot(tangent)), 0.9999);
  }
}

TEST(TensorEstimation, IsNotKnownWhereThereIsNoShape)
{
  const Point place(5e5 + 0.1, 5e6, 1);
  for (const auto& [centroid, name] : Names<Centroid>::table) {
    SCOPED_TRACE(std::string(name));
    const TensorSettings settings = withRadius(2, Kernel::FermiDirac1, centroid);
    EXPECT_TRUE(estimateTensors({place}, {}, settings).empty());
    EXPECT_EQ(tensorAt({}, place, settings).neighbors, 0u);
    EXPECT_TRUE(shapeOf(tensorAt({}, place, settings)).hasNaN());

    const PointDistributionTensor single = tensorAt({place}, place, settings);
    EXPECT_EQ(single.neighbors, 1u);
    const PointDistributionTensor coincident =
        tensorAt(Points(40, place), place, settings);
    EXPECT_EQ(coincident.neighbors, 40u);
    for (const PointDistributionTensor& record : {single, coincident}) {
      // Every float of the record, whatever its name.
      float values[18];
      std::memcpy(values, &record, sizeof(values));
      for (const float value : values)
        EXPECT_TRUE(std::isnan(value));
    }
  }
  // Seen from beside, coincident points have a direction for pdt, but none around their
  // own centre, where rounding alone is left.
  const Point beside = place + Point(0.3, 0.4, 0);
  EXPECT_FLOAT_EQ(tensorAt(Points(40, place), beside, withRadius(2)).linearity, 1);
  for (const Centroid centroid :
       {Centroid::Mean, Centroid::WeightedMean, Centroid::Median})
    EXPECT_TRUE(std::isnan(
        tensorAt(Points(40, place), beside, withRadius(2, Kernel::Const, centroid))
            .linearity));
}

TEST(TensorEstimation, LeavesPointsThatAreNotFiniteAside)
{
  Points surface = scene(300, 5), queries = surface;
  const Records clean = estimateTensors(surface, queries, withRadius(1));
  surface.emplace_back(not_known, 0, 0);
  surface.emplace_back(0, infinite, 0);
  queries.emplace_back(0, 0, not_known);
  for (const Engine engine : {Engine::Grid, Engine::Tree}) {
    TensorSettings settings = withRadius(1);
    settings.engine = engine;
    const Records records = estimateTensors(surface, queries, settings);
    for (std::size_t i = 0; i < clean.size(); ++i) {
      EXPECT_EQ(records[i].neighbors, clean[i].neighbors);
      EXPECT_LE(shapeDifference(records[i], shapeOf(clean[i])), 1e-6);
    }
    EXPECT_EQ(records.back().neighbors, 0u);
    EXPECT_TRUE(std::isnan(records.back().major_z));
  }
}

TEST(TensorEstimation, DoesNotMoveWithTheCloud)
{
  // Multiples of 1/256 plus these offsets are exact in double: not a bit may change.
  const Points points = scene(500, 6);
  Points moved;
  for (const Point& point : points)
    moved.push_back(point + Point(5e5, 5.5e6, 64));
  for (const auto& [centroid, name] : Names<Centroid>::table) {
    for (const Engine engine : {Engine::Grid, Engine::Tree}) {
      SCOPED_TRACE(std::string(name) + " " + std::string(nameOf(engine)));
      TensorSettings settings = withRadius(1, Kernel::FermiDirac1, centroid);
      settings.engine = engine;
      const Records here = estimateTensors(points, points, settings);
      const Records there = estimateTensors(moved, moved, settings);
      for (std::size_t i = 0; i < here.size(); ++i) {
        EXPECT_EQ(here[i].neighbors, there[i].neighbors);
        EXPECT_LE(shapeDifference(here[i], shapeOf(there[i])), 1e-6) << "query " << i;
      }
    }
  }
}

TEST(TensorEstimation, ScalesWithTheSquareAndTurnsWithTheCloud)
{
  const Points points = scene(500, 7);
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(1.1, Point(3, -1, 2).normalized()).toRotationMatrix();
  Points scaled, turned;
  for (const Point& point : points) {
    scaled.push_back(8 * point);
    turned.push_back(turn * point);
  }
  for (const auto& [centroid, name] : Names<Centroid>::table) {
    SCOPED_TRACE(std::string(name));
    // No point lies so close to this radius that the turn could move it across.
    TensorSettings settings = withRadius(1.0012345, Kernel::FermiDirac1, centroid);
    const Records original = estimateTensors(points, points, settings);
    const Records after = estimateTensors(turned, turned, settings);
    settings.radius *= 8;
    const Records large = estimateTensors(scaled, scaled, settings);
    for (std::size_t i = 0; i < points.size(); ++i) {
      ASSERT_EQ(original[i].neighbors, large[i].neighbors);
      ASSERT_EQ(std::isnan(original[i].lambda3), std::isnan(large[i].lambda3));
      if (std::isnan(original[i].lambda3))
        continue;
      EXPECT_FLOAT_EQ(64 * original[i].lambda3, large[i].lambda3);
      EXPECT_FLOAT_EQ(original[i].sphericity, large[i].sphericity);
      ASSERT_EQ(original[i].neighbors, after[i].neighbors);
      EXPECT_LE(shapeDifference(original[i], shapeOf(after[i])), 1e-5) << "query " << i;
      if (original[i].linearity > 0.1) {
        EXPECT_NEAR(
            std::abs((turn * majorOf(original[i])).dot(majorOf(after[i]))), 1, 1e-5);
      }
    }
  }
}

TEST(TensorEstimation, GivesTheSameBitsForAnyNumberOfThreads)
{
  const Points points = scene(3000, 8);
  for (const Engine engine : {Engine::Grid, Engine::Tree}) {
    TensorSettings settings = withRadius(0.7, Kernel::Cubic, Centroid::Median);
    settings.engine = engine;
    settings.threads = 1;
    const Records serial = estimateTensors(points, points, settings);
    for (const unsigned threads : {2u, 5u, 0u}) {
      settings.threads = threads;
      EXPECT_TRUE(sameBits(serial, estimateTensors(points, points, settings)));
    }
  }
}

TEST(TensorEstimation, ByKTakesTheNearestAndTheirReachAsRadius)
{
  const Points points = scene(400, 9);
  for (const Engine engine : {Engine::Auto, Engine::Grid, Engine::Tree}) {
    TensorSettings by_k;
    by_k.k = 12;
    by_k.engine = engine;
    const Records records = estimateTensors(points, points, by_k);
    for (std::size_t i = 0; i < points.size(); ++i) {
      std::vector<double> distances;
      for (const Point& point : points)
        distances.push_back((point - points[i]).norm());
      std::sort(distances.begin(), distances.end());
      ASSERT_EQ(records[i].neighbors, 12u);
      if (distances[11] == distances[12])
        continue; // another point at the same distance, not for a radius to tell
      EXPECT_LE(
          shapeDifference(
              records[i],
              bruteForce(points, points[i], withRadius(distances[11] * (1 + 1e-12)))
                  .shape),
          1e-5);
    }
  }
  TensorSettings all;
  all.k = 1000;
  EXPECT_EQ(estimateTensors(points, points, all).front().neighbors, 400u);
}

TEST(TensorEstimation, TakesSizesPointByPoint)
{
  const Points points = scene(400, 10);
  NeighbourhoodSizes sizes;
  for (std::size_t i = 0; i < points.size(); ++i)
    sizes.radii.push_back(0.5 + 0.01 * static_cast<double>(i % 100));
  sizes.radii[3] = not_known;
  sizes.radii[4] = 0;
  sizes.radii[5] = -1;
  sizes.radii[6] = infinite;
  for (const Engine engine : {Engine::Grid, Engine::Tree}) {
    TensorSettings settings;
    settings.engine = engine;
    const Records records = estimateTensors(points, points, settings, sizes);
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (i >= 3 && i <= 6) {
        EXPECT_TRUE(std::isnan(records[i].linearity));
        EXPECT_EQ(records[i].neighbors, 0u);
        continue;
      }
      const Expected expected =
          bruteForce(points, points[i], withRadius(sizes.radii[i]));
      EXPECT_EQ(records[i].neighbors, expected.neighbors);
      EXPECT_LE(shapeDifference(records[i], expected.shape), 1e-5);
    }
  }

  NeighbourhoodSizes counts;
  counts.counts.assign(points.size(), 9);
  counts.counts[1] = 0;
  TensorSettings nine;
  nine.k = 9;
  Records by_count = estimateTensors(points, points, {}, counts);
  EXPECT_TRUE(std::isnan(by_count[1].linearity));
  by_count[1] = estimateTensors(points, points, nine)[1];
  EXPECT_TRUE(sameBits(by_count, estimateTensors(points, points, nine)));
}

TEST(TensorEstimation, RefusesSizesThatMakeNoSense)
{
  const Points points = scene(10, 1);
  TensorSettings none, both = withRadius(1);
  both.k = 5;
  NeighbourhoodSizes few;
  few.radii = {1, 2};
  EXPECT_THROW(estimateTensors(points, points, none), std::invalid_argument);
  EXPECT_THROW(estimateTensors(points, points, both), std::invalid_argument);
  EXPECT_THROW(estimateTensors(points, points, none, few), std::invalid_argument);
  EXPECT_THROW(estimateTensors(points, {points[0], points[1]}, withRadius(1), few),
               std::invalid_argument);
  for (const double radius : {-1.0, infinite, not_known}) {
    try {
      estimateTensors(points, points, withRadius(radius));
      ADD_FAILURE() << radius;
    }
    catch (const std::invalid_argument& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr("not a positive finite number"));
    }
  }
}

namespace {

class Counter : public Monitor {
public:
  explicit Counter(std::size_t end) : end_(end) {}
  void
  advance(std::size_t steps) override
  {
    done += steps;
  }
  bool
  cancelled() const override
  {
    return done >= end_;
  }
  std::atomic<std::size_t> done{0};

private:
  std::size_t end_;
};

} // namespace

TEST(TensorEstimation, TellsItsProgressAndStopsWhenAsked)
{
  const Points points = scene(5000, 11);
  Counter all(points.size() + 1);
  estimateTensors(points, points, withRadius(0.2), {}, &all);
  EXPECT_EQ(all.done, points.size());
  Counter some(1000);
  EXPECT_THROW(estimateTensors(points, points, withRadius(0.2), {}, &some), Cancelled);
}
