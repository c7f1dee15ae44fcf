// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// Records of a piece of a cloud, computed from the piece and a margin around it, are
// bit for bit those of the whole cloud.

#include "features/simd_grid/test_grid_engine.h"
#include "random_seed.h"

#include <cstring>
#include <numeric>
#include <random>

#include <linelet/features/multi_scale.h>

using namespace linelet;
using namespace linelet::test;

namespace {

/** \brief Thin ground, a dense spot and a wire: blocks of all densities, and points on
 * a grid of centimeters, many of them equidistant. */
Points
scene(unsigned seed)
{
  Points points = uniformPoints(6000, {40, 20, 0.2}, seed);
  for (const Point& p : uniformPoints(4000, {3, 3, 3}, seed + 1))
    points.push_back(p + Point(4, 0, 1));
  for (const Point& p : uniformPoints(1000, {40, 0.02, 0.02}, seed + 2))
    points.push_back(p + Point(0, 5, 8));
  boost::random::mt19937 random(seed);
  for (std::size_t i = points.size(); i > 1; --i)
    std::swap(points[i - 1], points[random() % i]);
  for (Point& p : points)
    p = (p * 100).array().round() / 100;
  return points;
}

struct Cut {
  Points points;
  std::vector<double> radii;
  CloudPiece piece;
  Indices taken; // of the points of the piece
};

/** \brief The points with x from \a low to \a high, and those within \a margin. */
Cut
cut(const Points& whole,
    const std::vector<double>& radii,
    double low,
    double high,
    double margin)
{
  const auto isInside = [&](const Point& p) { return p.x() >= low && p.x() < high; };
  Cut cut;
  cut.piece.low = cut.piece.high = whole.front();
  for (const Point& p : whole) {
    cut.piece.low = cut.piece.low.cwiseMin(p);
    cut.piece.high = cut.piece.high.cwiseMax(p);
  }
  // As files would deliver them: some points before the piece, some after it.
  for (const int part : {0, 1, 2}) {
    if (part == 1)
      cut.piece.begin = cut.points.size();
    for (std::size_t i = 0; i < whole.size(); ++i) {
      const Point& p = whole[i];
      const bool chosen = part == 1
                              ? isInside(p)
                              : !isInside(p) && (part == 0) == (p.x() < low) &&
                                    p.x() >= low - margin && p.x() <= high + margin;
      if (!chosen)
        continue;
      cut.points.push_back(p);
      if (!radii.empty())
        cut.radii.push_back(radii[i]);
      if (part == 1)
        cut.taken.push_back(static_cast<Index>(i));
    }
    if (part == 1)
      cut.piece.end = cut.points.size();
  }
  return cut;
}

template <class Record>
::testing::AssertionResult
sameBits(const Record& a, const Record& b)
{
  if (std::memcmp(&a, &b, sizeof a) == 0)
    return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << a.linearity << " and " << b.linearity;
}

} // namespace

TEST(GridEnginePieces, HaveTheRecordsOfTheWhole)
{
  const unsigned seed = randomSeed();
  const Points whole = scene(seed);
  for (const char* weight : {"const", "fermi-dirac-1", "quadratic", "step:0.5"})
    for (const Centroid centroid : {Centroid::QueryPoint, Centroid::Mean})
      for (const double radius : {0.2, 1.0, 3.0, 200.0, 0.0}) {
        SCOPED_TRACE(std::string(weight) + ", " + std::string(nameOf(centroid)) +
                     ", radius " + std::to_string(radius));
        TensorSettings settings;
        settings.weighting = Weighting(weight);
        if (radius > 100 && settings.weighting.kernel() == Kernel::Step)
          continue; // all pairs in double: too slow
        settings.centroid = centroid;
        settings.radius = radius;
        settings.engine = Engine::Grid;
        NeighborhoodSizes sizes;
        for (std::size_t i = 0; i < whole.size() && radius == 0; ++i)
          sizes.radii.push_back(0.3 + 0.2 * static_cast<double>(i % 9));
        const auto expected = estimateTensors(whole, whole, settings, sizes);
        const double margin = tensorMargin(settings, sizes);
        for (const auto& [low, high] :
             {std::make_pair(-20.0, -7.3), std::make_pair(3.0, 5.0)}) {
          const Cut part = cut(whole, sizes.radii, low, high, margin);
          const auto records =
              pieceTensors(part.points, part.piece, settings, {part.radii, {}});
          ASSERT_EQ(records.size(), part.taken.size());
          for (std::size_t i = 0; i < records.size(); ++i)
            ASSERT_TRUE(sameBits(records[i], expected[part.taken[i]]))
                << "point " << part.taken[i];
        }
      }
}

// The tree returns neighbors in the order of their indices, which differs in a piece.
TEST(GridEnginePieces, HaveTheRecordsOfTheWholeFromATree)
{
  const Points whole = scene(randomSeed());
  for (const char* weight : {"const", "fermi-dirac-1"}) {
    TensorSettings settings;
    settings.weighting = Weighting(weight);
    settings.radius = 1;
    settings.engine = Engine::Tree;
    const auto expected = estimateTensors(whole, whole, settings);
    const Cut part = cut(whole, {}, 3, 5, tensorMargin(settings));
    const auto records = pieceTensors(part.points, part.piece, settings);
    ASSERT_EQ(records.size(), part.taken.size());
    for (std::size_t i = 0; i < records.size(); ++i)
      ASSERT_TRUE(sameBits(records[i], expected[part.taken[i]]))
          << weight << ", point " << part.taken[i];
  }
}

// Two points close together form a cloud smaller than any radius; as a piece of a
// larger one they do not.
TEST(GridEnginePieces, MayBeSmallerThanTheRadius)
{
  Points whole = {Point(0, 0, 0), Point(0.1, 0.03, 0), Point(0.04, 0.1, 0.02)};
  for (const Point& p : uniformPoints(500, {5, 5, 5}, 8))
    whole.push_back(p + Point(30, 0, 0));
  TensorSettings settings;
  settings.radius = 2;
  settings.engine = Engine::Grid;
  const auto expected = estimateTensors(whole, whole, settings);
  const Cut part = cut(whole, {}, -1, 1, tensorMargin(settings));
  ASSERT_EQ(part.points.size(), 3u);
  const auto records = pieceTensors(part.points, part.piece, settings);
  for (std::size_t i = 0; i < records.size(); ++i)
    EXPECT_TRUE(sameBits(records[i], expected[i]));
}

TEST(GridEnginePieces, HaveTheShapesOfTheWhole)
{
  const unsigned seed = randomSeed();
  const Points whole = scene(seed);
  for (const char* weight : {"const", "fermi-dirac-1"})
    for (const Centroid centroid : {Centroid::QueryPoint, Centroid::Mean}) {
      SCOPED_TRACE(std::string(weight) + ", " + std::string(nameOf(centroid)));
      MultiScaleSettings settings;
      settings.weighting = Weighting(weight);
      settings.centroid = centroid;
      settings.radii = {0.15, 0.3, 0.6, 1.2, 2.4};
      settings.engine = ScaleEngine::Grid;
      const auto expected = multiScaleShapes(whole, whole, settings).shapes;
      for (const auto& [low, high] :
           {std::make_pair(-20.0, -7.3), std::make_pair(3.0, 5.0)}) {
        const Cut part = cut(whole, {}, low, high, multiScaleMargin(settings.radii));
        const auto shapes = pieceShapes(part.points, part.piece, settings).shapes;
        ASSERT_EQ(shapes.size(), part.taken.size());
        for (std::size_t i = 0; i < shapes.size(); ++i)
          ASSERT_TRUE(sameBits(shapes[i], expected[part.taken[i]]))
              << "point " << part.taken[i];
      }
    }
}

// The order of the points in a file is independent of their positions.
TEST(GridEnginePieces, DoNotDependOnTheOrderOfThePoints)
{
  const unsigned seed = randomSeed();
  const Points points = uniformPoints(8000, {12, 12, 1}, seed);
  Indices order(points.size());
  std::iota(order.begin(), order.end(), Index{0});
  boost::random::mt19937 random(seed);
  for (std::size_t i = order.size(); i > 1; --i)
    std::swap(order[i - 1], order[random() % i]);
  Points shuffled;
  for (const Index i : order)
    shuffled.push_back(points[i]);
  for (const char* weight : {"const", "fermi-dirac-1"}) {
    TensorSettings settings;
    settings.weighting = Weighting(weight);
    settings.radius = 0.8;
    const auto expected = estimateTensorsOnGrid(points, points, settings);
    const auto records = estimateTensorsOnGrid(shuffled, shuffled, settings);
    for (std::size_t i = 0; i < order.size(); ++i)
      ASSERT_TRUE(sameBits(records[i], expected[order[i]])) << "point " << order[i];
  }
}
