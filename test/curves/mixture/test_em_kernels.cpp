// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_real_distribution.hpp>
#include <gtest/gtest.h>

#include "curves/mixture/em_kernels.h"

using namespace linelet;

namespace {

constexpr std::size_t count = 21; // not a multiple of any vector length

/** \brief Random points around the origin, with room for whole vectors. */
class Cloud {
public:
  explicit Cloud(unsigned seed)
  {
    boost::random::mt19937 random(seed);
    boost::random::uniform_real_distribution<double> place(-2, 2);
    for (auto& axis : at_) {
      axis.assign(count + EdgePoints::padding, 0);
      for (std::size_t k = 0; k < count; ++k)
        axis[k] = place(random);
    }
  }

  EdgePoints
  points() const
  {
    return {count, at_[0].data(), at_[1].data(), at_[2].data()};
  }

private:
  std::array<std::vector<double>, 3> at_;
};

/** \brief An edge along x, starting at \a from. */
EdgeShape
edgeAlongX(double from, double length, double variance, bool is_short)
{
  return {{from, 0.1, -0.2}, {1, 0, 0}, length, variance, 3, is_short};
}

} // namespace

TEST(EmKernels, AShortEdgeHasANormalDensityOfItsOwn)
{
  const Cloud cloud(1);
  const EdgePoints points = cloud.points();
  const double length = 0.4, variance = 0.3, along = variance + length * length / 12;
  std::vector<double> density(count + EdgePoints::padding);
  emKernels().densities(
      edgeAlongX(-0.1, length, variance, true), points, density.data());
  for (std::size_t k = 0; k < count; ++k) {
    const double x = points.x[k] + 0.1 - length / 2, y = points.y[k] - 0.1,
                 z = points.z[k] + 0.2;
    const double wanted =
        3 * std::exp(-0.5 * (x * x / along + (y * y + z * z) / variance));
    EXPECT_NEAR(density[k], wanted, 1e-8 * wanted) << k;
  }
}

TEST(EmKernels, ALongEdgeHasTheIntegralOfTheNormalDensityAlongIt)
{
  const Cloud cloud(2);
  const EdgePoints points = cloud.points();
  const double length = 1.5, variance = 0.25, noise = std::sqrt(variance);
  std::vector<double> density(count + EdgePoints::padding);
  emKernels().densities(
      edgeAlongX(-0.5, length, variance, false), points, density.data());
  const auto below = [&](double x) { return 0.5 * std::erfc(-x / (noise * M_SQRT2)); };
  for (std::size_t k = 0; k < count; ++k) {
    const double x = points.x[k] + 0.5, y = points.y[k] - 0.1, z = points.z[k] + 0.2;
    const double across = 3 * std::exp(-0.5 * (y * y + z * z) / variance);
    EXPECT_NEAR(density[k], across * (below(x) - below(x - length)), 4e-4 * across)
        << k;
  }
}

TEST(EmKernels, FarPointsHaveHardlyAnyDensityButANumber)
{
  std::vector<double> far(1 + EdgePoints::padding, 1e6);
  std::vector<double> density(1 + EdgePoints::padding, -1);
  for (const bool is_short : {false, true}) {
    emKernels().densities(edgeAlongX(0, 1, 0.01, is_short),
                          {1, far.data(), far.data(), far.data()},
                          density.data());
    EXPECT_GE(density[0], 0);
    EXPECT_LT(density[0], 1e-290);
  }
}

TEST(EmKernels, SharesAreNormalizedAndLeaveTheNextEdgeAlone)
{
  const std::vector<double> inverse = {0.5, 2, 4, 0.25};
  for (std::size_t own = 0; own <= count; ++own) {
    std::vector<double> densities;
    Indices sorted_indices;
    for (std::size_t k = 0; k < count; ++k) {
      densities.push_back(1.0 + static_cast<double>(k));
      sorted_indices.push_back(static_cast<Index>(k * 7 % inverse.size()));
    }
    const std::vector<double> before = densities;
    const double sum =
        emKernels().share(inverse.data(), sorted_indices.data(), densities.data(), own);
    double wanted = 0;
    for (std::size_t k = 0; k < count; ++k) {
      const double share = k < own ? before[k] * inverse[sorted_indices[k]] : before[k];
      EXPECT_EQ(densities[k], share) << k << " of " << own;
      wanted += k < own ? share : 0;
    }
    EXPECT_NEAR(sum, wanted, 1e-12 * wanted);
  }
}
