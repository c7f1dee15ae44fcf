// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <linelet/opencl/device_cost.h>

using namespace linelet;
using opencl::DeviceCost;
using opencl::isCheapest;

namespace {

/** \brief A fast device behind a slow bus. */
constexpr DeviceCost gpu = {0.5, 1e-7, 1e-11};
constexpr EngineWork much = {20000000, 20000000, 5000, false};

} // namespace

TEST(DeviceCost, TheDeviceIsTakenWhereItPays)
{
  // A small cloud is finished before the kernels are built.
  EXPECT_FALSE(isCheapest(gpu, {200000, 200000, 50, false}, TensorSettings()));
  EXPECT_TRUE(isCheapest(gpu, much, TensorSettings()));
  EXPECT_EQ(cheapestEngine(much), Engine::Grid);
  // A device no faster than one thread never pays.
  EXPECT_FALSE(isCheapest({0.5, 3e-7, 2e-9}, much, TensorSettings()));
}

TEST(DeviceCost, MissingFeaturesRuleItOut)
{
  const DeviceCost at_once = {0, 0, 0};
  TensorSettings median, unbounded;
  median.centroid = Centroid::WeightedMedian;
  unbounded.weighting = Kernel::InverseDistance;
  EXPECT_FALSE(isCheapest(at_once, {9, 9, 5, false}, unbounded));
  EXPECT_TRUE(isCheapest(at_once, {9, 9, 5, false}, TensorSettings()));
  EXPECT_FALSE(isCheapest(at_once, {9, 9, 5, false}, median));
  EXPECT_FALSE(isCheapest(at_once, {1000000, 1000000, 20, true}, TensorSettings()));
}
