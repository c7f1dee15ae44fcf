// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_real_distribution.hpp>
#include <gtest/gtest.h>

#include <linelet/features/grid_tensor_engine.h>
#include <linelet/features/tensor_estimation.h>

namespace linelet::test {

inline Points
uniformPoints(std::size_t count, const Point& extent, unsigned seed)
{
  boost::random::mt19937 random(seed);
  boost::random::uniform_real_distribution<double> unit(-0.5, 0.5);
  Points points;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = unit(random), y = unit(random), z = unit(random);
    points.emplace_back(extent.x() * x, extent.y() * y, extent.z() * z);
  }
  return points;
}

/** \brief The number of records that differ where they must not: numbers of neighbors,
 * which records are unknown, shape factors beyond 1e-4, eigenvalues beyond 1e-4 of
 * their sum, and e3 and e1 beyond 1e-3 where the eigenvalues are well apart. */
inline ::testing::AssertionResult
agree(const std::vector<PointDistributionTensor>& grid,
      const std::vector<PointDistributionTensor>& reference)
{
  if (grid.size() != reference.size())
    return ::testing::AssertionFailure() << grid.size() << " records";
  for (std::size_t i = 0; i < grid.size(); ++i) {
    const PointDistributionTensor &g = grid[i], &r = reference[i];
    const auto fail = [&](const char* what, double a, double b) {
      return ::testing::AssertionFailure()
             << what << " of point " << i << ": " << a << ", but the reference has "
             << b << " (" << r.neighbors << " neighbors)";
    };
    if (g.neighbors != r.neighbors)
      return fail("neighbors", g.neighbors, r.neighbors);
    if (std::isnan(g.linearity) != std::isnan(r.linearity))
      return fail("linearity", g.linearity, r.linearity);
    if (std::isnan(r.linearity))
      continue;
    const auto differ = [](double a, double b, double by) {
      return !(std::abs(a - b) <= by);
    };
    if (differ(g.linearity, r.linearity, 1e-4))
      return fail("linearity", g.linearity, r.linearity);
    if (differ(g.planarity, r.planarity, 1e-4))
      return fail("planarity", g.planarity, r.planarity);
    if (differ(g.sphericity, r.sphericity, 1e-4))
      return fail("sphericity", g.sphericity, r.sphericity);
    const double sum = r.lambda1 + r.lambda2 + r.lambda3;
    if (differ(g.lambda1, r.lambda1, 1e-4 * sum))
      return fail("lambda1", g.lambda1, r.lambda1);
    if (differ(g.lambda3, r.lambda3, 1e-4 * sum))
      return fail("lambda3", g.lambda3, r.lambda3);
    if (differ(g.xx, r.xx, 1e-4 * sum) || differ(g.yz, r.yz, 1e-4 * sum))
      return fail("xx", g.xx, r.xx);
    const double major =
        g.major_x * r.major_x + g.major_y * r.major_y + g.major_z * r.major_z;
    if (r.linearity > 0.2 && differ(std::abs(major), 1, 1e-6))
      return fail("e3 . e3", major, 1);
    const double normal =
        g.normal_x * r.normal_x + g.normal_y * r.normal_y + g.normal_z * r.normal_z;
    if (r.planarity > 0.4 && differ(std::abs(normal), 1, 1e-6))
      return fail("e1 . e1", normal, 1);
  }
  return ::testing::AssertionSuccess();
}

/** \brief Compares the grid engine with the kd-tree at some of the points. */
inline ::testing::AssertionResult
gridAgrees(const Points& surface,
           TensorSettings settings,
           const NeighborhoodSizes& sizes = {},
           std::size_t at_most = 400)
{
  settings.threads = 1; // more would exceed small clouds
  const auto grid = estimateTensorsOnGrid(surface, surface, settings, sizes);
  settings.engine = Engine::Tree;
  const std::size_t step = std::max<std::size_t>(1, surface.size() / at_most);
  Points queries;
  NeighborhoodSizes query_sizes;
  std::vector<PointDistributionTensor> some;
  for (std::size_t i = 0; i < surface.size(); i += step) {
    queries.push_back(surface[i]);
    if (!sizes.empty())
      query_sizes.radii.push_back(sizes.radii[i]);
    some.push_back(grid[i]);
  }
  return agree(some, estimateTensors(surface, queries, settings, query_sizes));
}

} // namespace linelet::test
