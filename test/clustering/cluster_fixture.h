// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <vector>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <boost/random/uniform_real_distribution.hpp>

#include <linelet/clustering/cluster_points.h>

namespace linelet::test {

using CellKey = std::array<std::int32_t, 3>;

/** \brief Two faces of a roof, their edges above the ground, and a wall, all noisy. */
inline Points
house(std::size_t count, unsigned seed, double noise = 0.02)
{
  boost::random::mt19937 random(seed);
  boost::random::uniform_real_distribution<double> uniform(0, 1);
  boost::random::normal_distribution<double> normal(0, noise);
  Points points;
  while (points.size() < count) {
    const double x = 20 * uniform(random), y = 12 * uniform(random);
    const bool roof = x > 4.3 && x < 15.1 && y > 2.2 && y < 9.7;
    const double z = roof ? 6 - 0.7 * std::abs(x - 9.7) : 0.01 * x;
    points.emplace_back(x, y, z + normal(random));
  }
  return points;
}

/** \brief The members of every representative. */
inline std::vector<Indices>
membersOf(const Clusters& clusters)
{
  std::vector<Indices> members(clusters.representatives.size());
  for (std::size_t i = 0; i < clusters.cluster_of.size(); ++i)
    if (clusters.cluster_of[i] != Clusters::none)
      members[clusters.cluster_of[i]].push_back(static_cast<Index>(i));
  return members;
}

/** \brief The boxes of the cells, computed independently. */
inline std::vector<CellKey>
homes(const Points& points, const Point& low, const Point& size, const CellKey& cells)
{
  std::vector<CellKey> result;
  for (const Point& p : points) {
    CellKey cell{};
    for (std::size_t a = 0; a < 3; ++a) {
      const auto axis = static_cast<Eigen::Index>(a);
      cell[a] = std::min(
          static_cast<std::int32_t>(std::floor((p[axis] - low[axis]) / size[axis])),
          cells[a] - 1);
    }
    result.push_back(cell);
  }
  return result;
}

inline Point
lowest(const Points& points)
{
  Point low = points.front();
  for (const Point& p : points)
    low = low.cwiseMin(p);
  return low;
}

inline ClusterSettings
settingsOf(double leaf, unsigned moves, MoveRule rule = MoveRule::Plane)
{
  ClusterSettings settings;
  settings.leaf = leaf;
  settings.moves = moves;
  settings.move_by = rule;
  return settings;
}

} // namespace linelet::test
