// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/search/kd_tree.h>

#include "opencl/tensor_engine_fixture.h"

using namespace linelet;
using namespace linelet::test;

TEST_F(OpenCL, RadiiPointByPoint)
{
  const Points points = box(800, Point(5, 5, 5), 9);
  NeighborhoodSizes sizes;
  for (std::size_t i = 0; i < points.size(); ++i)
    sizes.radii.push_back(0.2 + 0.002 * static_cast<double>(i % 400));
  sizes.radii[3] = not_known;
  sizes.radii[4] = 0;
  sizes.radii[5] = -1;
  TensorSettings settings;
  check(points, points, settings, sizes);
}

// Where the weight ends in a step, rounding of the coordinates must not decide the
// weight of a point on the ball.
TEST_F(OpenCL, PointsOnTheBallAreWeighedAsTheReferenceDoes)
{
  const Points points = box(800, Point(5, 2, 0.5), 10);
  const KdTree tree(points);
  NeighborhoodSizes sizes;
  Indices near;
  for (const Point& point : points)
    sizes.radii.push_back(tree.nearest(point, 7, near));
  TensorSettings settings;
  settings.weighting = Kernel::EaseExponential;
  check(points, points, settings, sizes);
}

TEST_F(OpenCL, RadiiOfAllMagnitudesCountExactly)
{
  // A fine lattice inside a coarse one: pairs exactly at the radius everywhere.
  Points points;
  NeighborhoodSizes sizes;
  for (const double step : {1.0, 0.001})
    for (int i = 0; i < 1000; ++i) {
      points.emplace_back(step * (i % 10), step * (i / 10 % 10), step * (i / 100));
      sizes.radii.push_back(step * (1 + i % 3));
    }
  check(points, points, TensorSettings(), sizes);
}

TEST_F(OpenCL, NearestPointsAreThoseOfTheReference)
{
  Points points = box(3000, Point(12, 9, 3), 17);
  points.emplace_back(not_known, 0, 0);
  Points queries = points;
  queries.emplace_back(6, 4, 9); // above the cloud
  for (const unsigned k : {1u, 5u, 30u, 400u}) {
    SCOPED_TRACE(k);
    TensorSettings settings;
    settings.k = k;
    check(points, queries, settings);
    if (k == 1)
      continue; // every point is its own nearest neighbor, and no ball is that small
    EXPECT_LT(engine->queriesOnHost(), queries.size() / 20);
    EXPECT_GT(engine->stageTimes().nearest, 0);
  }
}

TEST_F(OpenCL, NearestPointsWithACountForEveryPoint)
{
  const Points points = box(700, Point(5, 5, 1), 18);
  NeighborhoodSizes sizes;
  for (std::size_t i = 0; i < points.size(); ++i)
    sizes.counts.push_back(static_cast<unsigned>(i % 50));
  sizes.counts[7] = 5000; // more than there are
  check(points, points, TensorSettings(), sizes);
}

TEST_F(OpenCL, OfPointsEquallyFarTheLowerIndicesAreNearest)
{
  Points points;
  for (int i = 0; i < 1000; ++i)
    points.emplace_back(0.1 * (i % 10), 0.1 * (i / 10 % 10), 0.1 * (i / 100));
  points.insert(points.end(), points.begin(), points.begin() + 300);
  TensorSettings settings;
  settings.k = 20;
  check(points, points, settings);
  EXPECT_GT(engine->queriesOnHost(), 0u);
}
