// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "opencl/tensor_engine_fixture.h"

using namespace linelet;
using namespace linelet::test;

TEST_F(OpenCL, NearestPointsInAFewSlabs)
{
  const Points points = box(4000, Point(20, 5, 5), 19);
  TensorSettings settings;
  settings.k = 25;
  engine->setMemoryLimit(400000);
  check(points, points, settings);
  EXPECT_GT(engine->slabs(), 4u);
}

TEST_F(OpenCL, LittleMemoryOnlyMeansMoreSlabs)
{
  const Points points = box(4000, Point(20, 5, 5), 10);
  const TensorSettings settings = withRadius(0.8, "fermi-dirac-1");
  const auto whole = engine->estimate(points, points, settings);
  EXPECT_EQ(engine->slabs(), 1u);
  engine->setMemoryLimit(400000);
  const auto pieces = engine->estimate(points, points, settings);
  EXPECT_GT(engine->slabs(), 4u);
  expectEqual(whole, pieces, 1e-5);
}

TEST_F(OpenCL, CellsTooManyForAKeyOnlyMeanMoreSlabs)
{
  // 2^40 cells along every axis.
  Points points = box(600, Point(3, 3, 3), 12);
  for (std::size_t i = 0; i < points.size(); i += 3)
    points[i] += Point(1e12, -1e12, 1e12);
  check(points, points, withRadius(0.8));
  EXPECT_GT(engine->slabs(), 1u);
}

TEST_F(OpenCL, TheTableOfCellsCountsAsMemory)
{
  // One point per cell: 117 table entries per point, many times the rest.
  const Points points = box(3000, Point(900, 900, 900), 13);
  const TensorSettings settings = withRadius(10);
  engine->setMemoryLimit(1000000);
  check(points, points, settings);
  EXPECT_GT(engine->slabs(), 1u);
}
