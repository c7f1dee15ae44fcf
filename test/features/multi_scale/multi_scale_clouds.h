// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include <linelet/features/multi_scale.h>

namespace linelet_test {

inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();

inline double
uniform(std::mt19937& engine)
{
  return static_cast<double>(engine()) / 4294967296.0;
}

inline linelet::Points
randomPoints(std::size_t count, unsigned seed, const linelet::Point& size = {1, 1, 1})
{
  std::mt19937 engine(seed);
  linelet::Points points;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = uniform(engine), y = uniform(engine), z = uniform(engine);
    points.push_back(linelet::Point(x, y, z).cwiseProduct(size));
  }
  return points;
}

/// Points every \a step from \a from to \a to, both ends included.
inline void
addSegment(linelet::Points& points,
           const linelet::Point& from,
           const linelet::Point& to,
           double step)
{
  const int steps = static_cast<int>(std::lround((to - from).norm() / step));
  for (int i = 0; i <= steps; ++i)
    points.push_back(from + (to - from) * (static_cast<double>(i) / steps));
}

inline std::vector<linelet::ShapeGraph>
graphsOf(const linelet::Points& surface,
         const linelet::Points& queries,
         const linelet::MultiScaleSettings& settings,
         linelet::MultiScaleShapes* result = nullptr)
{
  std::vector<linelet::ShapeGraph> graphs;
  const linelet::MultiScaleShapes shapes = linelet::multiScaleShapes(
      surface,
      queries,
      settings,
      [&](std::size_t query, const linelet::ShapeGraph& graph) {
        EXPECT_EQ(query, graphs.size()); // in order
        graphs.push_back(graph);
      });
  EXPECT_EQ(graphs.size(), queries.size());
  if (result != nullptr)
    *result = shapes;
  return graphs;
}

} // namespace linelet_test
