// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_real_distribution.hpp>
#include <gtest/gtest.h>

#include <linelet/features/tensor_estimation.h>
#include <linelet/opencl/tensor_engine.h>

namespace linelet::test {

inline Points
box(std::size_t count, const Point& extent, unsigned seed)
{
  boost::random::mt19937 random(seed);
  boost::random::uniform_real_distribution<double> unit(0, 1);
  Points points;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = unit(random), y = unit(random), z = unit(random);
    points.emplace_back(extent.cwiseProduct(Point(x, y, z)));
  }
  return points;
}

/** \brief The reference: the kd-tree and double arithmetic. */
inline std::vector<PointDistributionTensor>
reference(const Points& surface,
          const Points& queries,
          TensorSettings settings,
          const NeighborhoodSizes& sizes)
{
  settings.engine = Engine::Tree;
  return estimateTensors(surface, queries, settings, sizes);
}

inline void
expectEqual(const std::vector<PointDistributionTensor>& a,
            const std::vector<PointDistributionTensor>& b,
            double tolerance = 1e-4)
{
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    SCOPED_TRACE("point " + std::to_string(i));
    ASSERT_EQ(a[i].neighbors, b[i].neighbors);
    ASSERT_EQ(std::isnan(a[i].linearity), std::isnan(b[i].linearity));
    if (std::isnan(a[i].linearity))
      continue;
    ASSERT_NEAR(a[i].linearity, b[i].linearity, tolerance);
    ASSERT_NEAR(a[i].planarity, b[i].planarity, tolerance);
    ASSERT_NEAR(a[i].sphericity, b[i].sphericity, tolerance);
  }
}

/** \brief An engine on the first device, and the reference it must agree with. */
class OpenCL : public ::testing::Test {
protected:
  void
  SetUp() override
  {
    if (opencl::devices().empty())
      GTEST_SKIP() << "no OpenCL device was found";
    engine = std::make_unique<opencl::TensorEngine>();
    ASSERT_TRUE(engine->device().double_precision);
  }

  void
  check(const Points& surface,
        const Points& queries,
        const TensorSettings& settings,
        const NeighborhoodSizes& sizes = {})
  {
    expectEqual(engine->estimate(surface, queries, settings, sizes),
                reference(surface, queries, settings, sizes));
  }

  std::unique_ptr<opencl::TensorEngine> engine;
};

inline TensorSettings
withRadius(double radius, Weighting weighting = Kernel::Const)
{
  TensorSettings settings;
  settings.radius = radius;
  settings.weighting = weighting;
  return settings;
}

constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

} // namespace linelet::test
