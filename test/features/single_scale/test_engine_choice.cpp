// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include <linelet/features/engine_choice.h>

using namespace linelet;

namespace {

/** \brief A square lattice of side \a side, with points one unit apart. */
Points
lattice(int side)
{
  Points points;
  for (int x = 0; x < side; ++x)
    for (int y = 0; y < side; ++y)
      points.emplace_back(x, y, 0);
  return points;
}

} // namespace

// Measured times of tree and grid in microseconds (one thread, see engine_choice.h), of
// which the smaller one must be chosen.
TEST(EngineChoice, FollowsWhatWasMeasured)
{
  struct Measured {
    EngineWork work;
    double tree, grid;
  };
  for (const Measured& m : {Measured{{100, 1, 10, false}, 3.4, 18},
                            Measured{{100, 10, 10, false}, 7.8, 23},
                            Measured{{1000, 1, 10, false}, 25, 58},
                            Measured{{1000, 10, 10, false}, 30, 66},
                            Measured{{1000, 100, 50, false}, 125, 84},
                            Measured{{1000, 1000, 10, false}, 832, 241},
                            Measured{{1000, 1000, 50, false}, 1764, 246},
                            Measured{{10000, 100, 500, false}, 3024, 1055},
                            Measured{{10000, 1000, 500, false}, 22047, 1666},
                            Measured{{200000, 1, 10, false}, 47797, 25211},
                            Measured{{200000, 1000, 5000, false}, 296546, 30707},
                            Measured{{200000, 20000, 500, false}, 531187, 31244},
                            Measured{{200000, 200000, 50, false}, 726434, 66783}}) {
    SCOPED_TRACE(std::to_string(m.work.points) + " points, " +
                 std::to_string(m.work.queries) + " queries, " +
                 std::to_string(m.work.neighbors) + " neighbors");
    EXPECT_EQ(cheapestEngine(m.work), m.tree < m.grid ? Engine::Tree : Engine::Grid);
    // The model is not a fit, but not a guess either.
    EXPECT_LT(
        std::abs(std::log2(estimatedSeconds(Engine::Grid, m.work) / m.grid * 1e6)),
        1.6);
  }
}

TEST(EngineChoice, NearestPointsAreForTheTree)
{
  EXPECT_EQ(cheapestEngine({1000000, 1000000, 20, true}), Engine::Tree);
}

TEST(EngineChoice, CountsNeighbors)
{
  const Points points = lattice(300); // more than are tested one by one
  TensorSettings settings;
  for (const double radius : {6.0, 12.0, 25.0}) {
    settings.radius = radius;
    const EngineWork work = engineWork(points, points, settings);
    EXPECT_EQ(work.points, points.size());
    EXPECT_EQ(work.queries, points.size());
    EXPECT_FALSE(work.nearest);
    EXPECT_GT(work.neighbors, M_PI * radius * radius / 2);
    EXPECT_LT(work.neighbors, M_PI * radius * radius * 2);
  }
  settings.radius = 0;
  settings.k = 17;
  EXPECT_EQ(engineWork(points, points, settings).neighbors, 17);
  EXPECT_TRUE(engineWork(points, points, settings).nearest);
  settings.k = 0;
  EXPECT_EQ(engineWork(lattice(9), {Point(4, 4, 0)}, settings, {{1.5}, {}}).neighbors,
            9);
  EXPECT_EQ(engineWork(points, {Point(0, 0, 0)}, settings, {{}, {5}}).neighbors, 5);
  settings.radius = 1;
  EXPECT_EQ(engineWork({}, {}, settings).neighbors, 0);
}

TEST(EngineChoice, AWishIsAWish)
{
  const Points points = lattice(3);
  TensorSettings settings;
  settings.radius = 1;
  for (const Engine engine : {Engine::Tree, Engine::Grid}) {
    settings.engine = engine;
    EXPECT_EQ(chosenEngine(points, points, settings), engine);
  }
  settings.engine = Engine::Auto;
  EXPECT_EQ(chosenEngine(points, {Point(0, 0, 0)}, settings), Engine::Tree);
  EXPECT_EQ(chosenEngine(lattice(200), lattice(200), settings), Engine::Grid);
}
