// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "features/simd_grid/test_grid_engine.h"

#include <cstring>
#include <limits>

#include <linelet/search/kd_tree.h>
#include <linelet/tensor/weighting.h>

#include "random_seed.h"

using namespace linelet;
using namespace linelet::test;

namespace {

Weighting
weightingOf(Kernel kernel)
{
  if (kernel == Kernel::FermiDirac)
    return Weighting::fermiDirac(0.5, 0.03);
  if (kernel == Kernel::Step)
    return Weighting::step(0.7);
  return {kernel};
}

/** \brief Half of the points in a thin wire, half around it. */
Points
wireScene(std::size_t count, unsigned seed)
{
  Points points = uniformPoints(count / 2, {10, 10, 10}, seed);
  for (const Point& p : uniformPoints(count / 2, {10, 0.002, 0.002}, seed + 1))
    points.emplace_back(p.x(), 0.3 * p.x() + p.y(), 0.1 * p.x() + p.z());
  return points;
}

} // namespace

TEST(GridEngine, AgreesForEveryKernelAndCentroid)
{
  const Points points = wireScene(1500, 7);
  for (const auto& kernel : Names<Kernel>::table)
    for (const auto& centroid : Names<Centroid>::table) {
      SCOPED_TRACE(std::string(kernel.second) + " " + std::string(centroid.second));
      // The medians are slow, and run the same code for every kernel.
      if ((centroid.first == Centroid::Median ||
           centroid.first == Centroid::WeightedMedian) &&
          kernel.first != Kernel::Const && kernel.first != Kernel::FermiDirac1)
        continue;
      TensorSettings settings;
      settings.radius = 1;
      settings.weighting = weightingOf(kernel.first);
      settings.centroid = centroid.first;
      if (!isUnbounded(kernel.first) || centroid.first == Centroid::QueryPoint) {
        EXPECT_TRUE(gridAgrees(points, settings, {}, 80));
      }
      // Every kernel also serves as the weight of centroids.
      if (centroid.first == Centroid::WeightedMean) {
        settings.centroid_weighting = settings.weighting;
        settings.weighting = Weighting();
        EXPECT_TRUE(gridAgrees(points, settings, {}, 80));
      }
    }
}

// The search stops at the extent of the cloud, but weights use the requested radius.
TEST(GridEngine, AgreesBeyondTheDiagonal)
{
  const Points points = wireScene(600, 9);
  for (const auto& kernel : Names<Kernel>::table)
    for (const Centroid centroid :
         {Centroid::QueryPoint, Centroid::Mean, Centroid::WeightedMean})
      for (const double radius : {20.0, 50.0, 3e3, 1e9}) {
        SCOPED_TRACE(std::string(kernel.second) + " radius " + std::to_string(radius));
        if (isUnbounded(kernel.first) && centroid != Centroid::QueryPoint)
          continue; // refused
        TensorSettings settings;
        settings.radius = radius;
        settings.weighting = weightingOf(kernel.first);
        settings.centroid = centroid;
        EXPECT_TRUE(gridAgrees(points, settings, {}, 20));
      }
  NeighborhoodSizes sizes;
  for (std::size_t i = 0; i < points.size(); ++i)
    sizes.radii.push_back(std::array<double, 5>{1, 15, 40, 1e4, 1e200}[i % 5]);
  for (const Kernel kernel : {Kernel::Const, Kernel::FermiDirac1, Kernel::Quadratic}) {
    TensorSettings settings;
    settings.weighting = kernel;
    EXPECT_TRUE(gridAgrees(points, settings, sizes, 50));
  }
  // Queries far from the points are only reached by the radius.
  TensorSettings settings;
  settings.radius = 1010;
  const Points far = {Point(1000, 0, 0), Point(2000, 0, 0)};
  const auto records = estimateTensorsOnGrid(points, far, settings);
  EXPECT_GT(records[0].neighbors, 400u);
  EXPECT_EQ(records[1].neighbors, 0u);
}

// This would take a hundred times as long query by query in double. Processor time of
// one run relative to another, with room for other load on the machine.
TEST(GridEngine, CostsNoMoreBeyondTheDiagonal)
{
  const Points points = uniformPoints(6000, {10, 10, 1}, 3);
  const auto processorTime = [&](Kernel kernel, double radius) {
    TensorSettings settings;
    settings.weighting = kernel;
    settings.radius = radius;
    settings.threads = 1;
    const std::clock_t begin = std::clock();
    estimateTensorsOnGrid(points, points, settings);
    return static_cast<double>(std::clock() - begin);
  };
  for (const Kernel kernel : {Kernel::Const, Kernel::FermiDirac1, Kernel::Quadratic}) {
    SCOPED_TRACE(nameOf(kernel));
    const double at_diagonal = processorTime(kernel, 14.2);
    EXPECT_LT(processorTime(kernel, 1e5), 25 * at_diagonal + CLOCKS_PER_SEC / 10);
  }
}

TEST(GridEngine, AgreesOnRandomClouds)
{
  const unsigned first_seed = randomSeed();
  for (unsigned i = 0; i < 60; ++i) {
    const unsigned seed = first_seed + i;
    boost::random::mt19937 random(seed);
    const auto uniform = [&](double low, double high) {
      return boost::random::uniform_real_distribution<double>(low, high)(random);
    };
    const auto power = [&](double low, double high) {
      return std::pow(10, uniform(low, high));
    };
    const auto count = static_cast<std::size_t>(power(0, 3.7));
    const Point extent(power(-2, 2), power(-2, 2), power(-2, 2));
    Points points = uniformPoints(count, extent, seed);
    const Point offset(uniform(-1e3, 1e3), uniform(-1e3, 1e3), uniform(-1e3, 1e3));
    const double step = uniform(0, 1) < 0.3 ? extent.maxCoeff() / 64 : 0;
    for (Point& p : points) {
      // Points on a lattice: distances equal to the radius, and duplicates.
      if (step > 0)
        p = (p / step).array().round() * step;
      p += offset;
    }
    TensorSettings settings;
    settings.radius = step > 0 ? 5 * step : extent.maxCoeff() * power(-2, 0.3);
    settings.weighting =
        weightingOf(Names<Kernel>::table[static_cast<std::size_t>(
                                             uniform(0, Names<Kernel>::count - 0.01))]
                        .first);
    if (i % 2 == 0)
      settings.weighting = i % 4 == 0 ? Kernel::Const : Kernel::FermiDirac1;
    settings.centroid =
        Names<Centroid>::table[static_cast<std::size_t>(uniform(0, 2.99))].first;
    // A lattice point may coincide with the mean of its neighbors; then rounding
    // decides on which side of the step at distance 0 its weight lies.
    if ((step > 0 && settings.weighting.name() == "ease-exponential") ||
        isUnbounded(settings.weighting.kernel()))
      settings.centroid = Centroid::QueryPoint;
    SCOPED_TRACE(std::to_string(count) + " points, radius " +
                 std::to_string(settings.radius) + ", " + settings.weighting.name() +
                 ", " + std::string(nameOf(settings.centroid)));
    EXPECT_TRUE(gridAgrees(points, settings, {}, 100));
  }
}

TEST(GridEngine, AgreesOnAdversarialClouds)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<std::pair<std::string, Points>> clouds;
  clouds.emplace_back("all in one cell", uniformPoints(1200, {0.5, 0.5, 0.5}, 1));
  clouds.emplace_back("one point per cell", uniformPoints(1200, {60, 60, 60}, 2));
  Points border;
  for (int i = 0; i < 1200; ++i)
    border.emplace_back(0.01 * i, 1.0, 2.0);
  clouds.emplace_back("a line along the border of cells", border);
  clouds.emplace_back("huge aspect ratio", uniformPoints(1200, {1e6, 1e-3, 1}, 3));
  Points twice = uniformPoints(500, {3, 3, 3}, 4);
  twice.insert(twice.end(), twice.begin(), twice.end());
  clouds.emplace_back("duplicates", twice);
  clouds.emplace_back("one place", Points(500, Point(1, 2, 3)));
  clouds.emplace_back("one point", Points(1, Point(1, 2, 3)));
  clouds.emplace_back("two points", Points{Point(0, 0, 0), Point(1 - 1e-12, 0, 0)});
  Points pair_far = uniformPoints(40, {1e-6, 1e-6, 1e-6}, 5);
  pair_far.emplace_back(0.99, 0, 0);
  clouds.emplace_back("a speck and one far point", pair_far);
  Points outlier = uniformPoints(500, {5, 5, 5}, 6);
  outlier.emplace_back(1e9, -1e9, 1e9);
  clouds.emplace_back("an outlier beyond all blocks", outlier);
  Points holes = uniformPoints(500, {4, 4, 4}, 7);
  holes[3].x() = nan;
  holes[77] = Point(0, std::numeric_limits<double>::infinity(), 0);
  holes[499] = Point(nan, nan, nan);
  clouds.emplace_back("points that are not finite", holes);
  clouds.emplace_back("nothing but NaN", Points(5, Point(nan, 0, 0)));
  clouds.emplace_back("empty", Points());

  for (const auto& [name, points] : clouds)
    for (const char* weight : {"const", "fermi-dirac-1", "quadratic"})
      for (const Centroid centroid :
           {Centroid::QueryPoint, Centroid::Mean, Centroid::WeightedMean})
        for (const double radius : {1.0, 1e-4, 50.0}) {
          if (radius == 50.0 && centroid == Centroid::WeightedMean)
            continue; // slow in the reference, and nothing new
          SCOPED_TRACE(name + ", " + weight + ", " + std::string(nameOf(centroid)) +
                       ", radius " + std::to_string(radius));
          TensorSettings settings;
          settings.radius = radius;
          settings.weighting = Weighting(weight);
          settings.centroid = centroid;
          EXPECT_TRUE(gridAgrees(points, settings, {}, 25));
        }
}

// Neighbors certain for many queries are summed separately from those that are tested,
// and weights come from tables; with thousands of neighbors most do. Duplicates, a
// dense spot and points near the query exercise the handover between tables and lists.
TEST(GridEngine, AgreesForThousandsOfNeighbors)
{
  Points flat = uniformPoints(9000, {6, 6, 0.05}, 61);
  Points spot = uniformPoints(6000, {4, 4, 4}, 62);
  for (const Point& p : uniformPoints(3000, {0.3, 0.3, 0.3}, 63))
    spot.push_back(p + Point(1, 0, 0));
  Points twice = uniformPoints(4000, {3, 3, 3}, 64);
  twice.insert(twice.end(), twice.begin(), twice.end());
  Points wire = wireScene(8000, 65);
  for (Point& p : wire)
    p += Point(1e3, -2e3, 5e2);
  for (const auto& [name, points] : {std::make_pair("a sheet", &flat),
                                     std::make_pair("a dense spot", &spot),
                                     std::make_pair("all points twice", &twice),
                                     std::make_pair("a wire far off", &wire)})
    for (const char* weight : {"fermi-dirac-1",
                               "fermi-dirac-2",
                               "fermi-dirac-3",
                               "fermi-dirac:0.5,0.02",
                               "fermi-dirac:2,5",
                               "sph-4",
                               "quadratic-inverse",
                               "quadratic",
                               "epanechnikov",
                               "const"}) {
      SCOPED_TRACE(std::string(name) + ", " + weight);
      TensorSettings settings;
      settings.radius = 1.6;
      settings.weighting = Weighting(weight);
      EXPECT_TRUE(gridAgrees(*points, settings, {}, 25));
    }
  // A radius per point: tables and polynomials are scaled.
  NeighborhoodSizes sizes;
  for (std::size_t i = 0; i < flat.size(); ++i)
    sizes.radii.push_back(1 + 0.1 * static_cast<double>(i % 9));
  for (const char* weight :
       {"fermi-dirac-1", "fermi-dirac-2", "fermi-dirac-3", "epanechnikov"}) {
    SCOPED_TRACE(weight);
    TensorSettings settings;
    settings.weighting = Weighting(weight);
    EXPECT_TRUE(gridAgrees(flat, settings, sizes, 25));
  }
}

TEST(GridEngine, TakesARadiusForEveryPoint)
{
  const Points points = wireScene(4000, 11);
  NeighborhoodSizes sizes;
  boost::random::mt19937 random(5);
  boost::random::uniform_real_distribution<double> exponent(-2, 0.6);
  for (std::size_t i = 0; i < points.size(); ++i)
    sizes.radii.push_back(std::pow(10, exponent(random)));
  sizes.radii[0] = 0;
  sizes.radii[10] = -1;
  sizes.radii[20] = std::numeric_limits<double>::infinity();
  for (const char* weight : {"const", "fermi-dirac-1"})
    for (const Centroid centroid : {Centroid::QueryPoint, Centroid::WeightedMean}) {
      TensorSettings settings;
      settings.weighting = Weighting(weight);
      settings.centroid = centroid;
      EXPECT_TRUE(gridAgrees(points, settings, sizes));
    }
}

// Where the weight ends in a step, rounding of the coordinates must not decide the
// weight of a point on the ball.
TEST(GridEngine, WeighsPointsOnTheBallAsTheReferenceDoes)
{
  const Points points = uniformPoints(3000, {10, 4, 0.5}, 41);
  const KdTree tree(points);
  NeighborhoodSizes sizes;
  Indices near;
  for (const Point& point : points)
    sizes.radii.push_back(tree.nearest(point, 7, near));
  for (const char* weight : {"ease-exponential", "fermi-dirac-1"}) {
    SCOPED_TRACE(weight);
    TensorSettings settings;
    settings.weighting = Weighting(weight);
    EXPECT_TRUE(gridAgrees(points, settings, sizes));
  }
}

// Where float arithmetic hands over to double, no point may be counted twice or not at
// all: thousands of points as near to the ball as rounding can resolve.
TEST(GridEngine, CountsEveryPointNextToTheBallOnce)
{
  boost::random::mt19937 random(51);
  boost::random::uniform_real_distribution<double> unit(-1, 1);
  const Points queries = uniformPoints(8, {0.4, 0.4, 0.4}, 52);
  Points surface;
  for (const Point& query : queries)
    for (int i = 0; i < 5000; ++i) {
      const Point direction(unit(random), unit(random), unit(random));
      const double distance = std::sqrt(1 + 1e-5 * unit(random));
      surface.emplace_back(query + distance * direction.normalized());
    }
  TensorSettings settings;
  settings.radius = 1;
  for (const char* weight : {"const", "fermi-dirac-1"}) {
    SCOPED_TRACE(weight);
    settings.weighting = Weighting(weight);
    settings.engine = Engine::Tree;
    EXPECT_TRUE(agree(estimateTensorsOnGrid(surface, queries, settings),
                      estimateTensors(surface, queries, settings)));
  }
}

TEST(GridEngine, TakesQueriesOffTheSurface)
{
  const Points surface = uniformPoints(3000, {8, 8, 8}, 21);
  Points queries = uniformPoints(300, {14, 14, 14}, 22);
  queries.emplace_back(1e12, 0, 0);
  queries.emplace_back(std::numeric_limits<double>::quiet_NaN(), 0, 0);
  TensorSettings settings;
  settings.radius = 1.5;
  for (const char* weight : {"const", "fermi-dirac-1"}) {
    settings.weighting = Weighting(weight);
    settings.engine = Engine::Tree;
    EXPECT_TRUE(agree(estimateTensorsOnGrid(surface, queries, settings),
                      estimateTensors(surface, queries, settings)));
  }
}

TEST(GridEngine, GivesTheSameBitsForAnyNumberOfThreads)
{
  const Points points = wireScene(6000, 31);
  TensorSettings settings;
  settings.radius = 0.8;
  for (const char* weight : {"const", "fermi-dirac-1"}) {
    settings.weighting = Weighting(weight);
    settings.threads = 1;
    const auto one = estimateTensorsOnGrid(points, points, settings);
    settings.threads = 3;
    const auto three = estimateTensorsOnGrid(points, points, settings);
    EXPECT_EQ(0,
              std::memcmp(one.data(), three.data(), one.size() * sizeof one.front()));
  }
}

TEST(GridEngine, FarFromTheOriginChangesNothing)
{
  Points points = wireScene(3000, 41);
  for (Point& p : points)
    p += Point(5e5, 5.5e6, 300);
  TensorSettings settings;
  settings.radius = 1;
  for (const Centroid centroid : {Centroid::QueryPoint, Centroid::Mean}) {
    settings.centroid = centroid;
    settings.weighting = Kernel::Const;
    EXPECT_TRUE(gridAgrees(points, settings));
  }
}

TEST(GridEngine, StopsOnRequest)
{
  struct Impatient : ProgressMonitor {
    bool
    canceled() const override
    {
      return true;
    }
  } monitor;
  const Points points = uniformPoints(2000, {10, 10, 10}, 51);
  TensorSettings settings;
  settings.radius = 1;
  EXPECT_THROW(estimateTensorsOnGrid(points, points, settings, {}, &monitor), Canceled);
}
