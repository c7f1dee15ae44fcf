// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include <linelet/opencl/cluster_engine.h>

#include "clustering/cluster_fixture.h"

using namespace linelet;
using namespace linelet::test;

namespace {

/** \brief Expects both to agree in every bit. */
void
expectSame(const Clusters& a, const Clusters& b)
{
  ASSERT_EQ(a.cluster_of, b.cluster_of);
  ASSERT_EQ(a.representatives.size(), b.representatives.size());
  EXPECT_EQ(a.leaf, b.leaf);
  for (std::size_t k = 0; k < a.representatives.size(); ++k) {
    const Representative &x = a.representatives[k], &y = b.representatives[k];
    ASSERT_EQ(x.center, y.center);
    ASSERT_EQ(x.tensor.matrix(), y.tensor.matrix());
    ASSERT_EQ(x.count, y.count);
    ASSERT_EQ(x.cell, y.cell);
  }
}

TEST(OpenCLClusters, AreThoseOfTheProcessorBitForBit)
{
  if (opencl::devices().empty())
    GTEST_SKIP() << "no OpenCL device was found";
  opencl::ClusterEngine engine;
  Points points = house(30000, 31);
  points[5].y() = std::nan("");
  std::vector<double> field;
  for (const Point& p : points)
    field.push_back(std::sin(p.x()) * p.z());
  field[9] = std::nan("");
  for (const MoveRule rule : {MoveRule::Plane, MoveRule::Population, MoveRule::Field})
    for (const double leaf : {0.03, 0.4, 3.}) { // marked bricks, cells, all of them
      SCOPED_TRACE(std::string(nameOf(rule)) + " " + std::to_string(leaf));
      const ClusterSettings settings = settingsOf(leaf, 3, rule);
      expectSame(engine.cluster(points, settings, field),
                 clusterPoints(points, settings, field));
    }
  ClusterSettings settings;
  settings.cells = {20, 15, 12};
  Camera camera;
  camera.lookAt(Point(-10, -5, 12), Point(10, 6, 0));
  settings.camera = camera;
  const Clusters expected = clusterPoints(points, settings);
  EXPECT_GT(expected.representatives.size(), 100u);
  expectSame(engine.cluster(points, settings), expected);
  settings = {};
  settings.count = 500;
  expectSame(engine.cluster(points, settings), clusterPoints(points, settings));
  // So many that the processor sums them with SIMD.
  const Points many = house(150001, 32);
  expectSame(engine.cluster(many, settingsOf(0.4, 2)),
             clusterPoints(many, settingsOf(0.4, 2)));
}

TEST(OpenCLClusters, OfNothingAreNothingAndNonsenseIsRefused)
{
  if (opencl::devices().empty())
    GTEST_SKIP() << "no OpenCL device was found";
  opencl::ClusterEngine engine;
  EXPECT_TRUE(engine.cluster({}, settingsOf(1, 2)).representatives.empty());
  EXPECT_THROW(engine.cluster({}, ClusterSettings()), std::invalid_argument);
}

} // namespace
