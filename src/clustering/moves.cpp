// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "moves.h"

#include <cstddef>
#include <limits>
#include <utility>

#include <linelet/tensor/eigen_analysis.h>

namespace linelet::clustering {

std::vector<std::uint8_t>
populationShifts(const std::vector<std::uint32_t>& border_counts,
                 std::vector<std::int64_t> populations,
                 const Indices& neighbors,
                 unsigned passes)
{
  const std::size_t slots = populations.size();
  std::vector<std::uint8_t> shifts(slots * faces);
  std::vector<std::int64_t> gains(slots);
  // A point moves between two cells, across the nearest face of its home cell.
  const auto flow = [&](std::size_t from, std::size_t to, std::uint32_t face) {
    // With six neighbors, more than a sixth of a difference could overshoot.
    std::int64_t allowed = (populations[from] - populations[to]) / faces;
    const std::int64_t most = allowed;
    std::uint8_t& back = shifts[to * faces + (face ^ 1U)];
    const auto candidates =
        [&](std::size_t slot, std::uint32_t side, std::uint32_t step) {
          return std::int64_t{border_counts[(slot * faces + side) * steps + step]};
        };
    while (back > 0 && candidates(to, face ^ 1U, back - 1U) <= allowed)
      allowed -= candidates(to, face ^ 1U, --back);
    std::uint8_t& out = shifts[from * faces + face];
    while (back == 0 && out < steps && candidates(from, face, out) <= allowed)
      allowed -= candidates(from, face, out++);
    gains[from] -= most - allowed;
    gains[to] += most - allowed;
  };
  for (unsigned pass = 0; pass < passes; ++pass) {
    gains.assign(slots, 0);
    for (std::size_t slot = 0; slot < slots; ++slot)
      for (std::uint32_t face = 1; face < faces; face += 2) {
        const Index other = neighbors[slot * faces + face];
        if (other == CellDirectory::none)
          continue;
        if (populations[slot] > populations[other])
          flow(slot, other, face);
        else if (populations[other] > populations[slot])
          flow(other, slot, face ^ 1U);
      }
    for (std::size_t slot = 0; slot < slots; ++slot)
      populations[slot] += gains[slot];
  }
  return shifts;
}

CellMoments
momentsOf(const CellSums& sums, const CellOrigin& origin)
{
  CellMoments moments;
  const auto count = static_cast<double>(sums.count);
  Point mean, unit;
  for (std::size_t a = 0; a < 3; ++a) {
    const auto axis = static_cast<Eigen::Index>(a);
    mean[axis] = static_cast<double>(sums.first[a]) / count;
    unit[axis] = 1 / origin.scale[a];
    moments.mean[axis] = origin.middle[a] + mean[axis] * unit[axis];
  }
  const auto covariance = [&](std::size_t entry, Eigen::Index a, Eigen::Index b) {
    const double square = static_cast<double>(sums.second[entry]) / count;
    return (square - mean[a] * mean[b]) * unit[a] * unit[b];
  };
  moments.tensor = {covariance(0, 0, 0),
                    covariance(1, 0, 1),
                    covariance(2, 0, 2),
                    covariance(3, 1, 1),
                    covariance(4, 1, 2),
                    covariance(5, 2, 2)};
  return moments;
}

CellPlane
planeOf(const CellSums& sums, const CellOrigin& origin)
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  CellPlane plane;
  plane.normal = {nan, nan, nan};
  if (sums.count < 3)
    return plane;
  const CellMoments moments = momentsOf(sums, origin);
  const EigenSystem system = eigenAnalysis(moments.tensor);
  // Offsets are rounded to integers: a spread below one unit is rounding.
  const double unit = 1 / origin.scale[0];
  if (!(system.values[1] > unit * unit))
    return plane;
  for (std::size_t a = 0; a < 3; ++a) {
    const auto axis = static_cast<Eigen::Index>(a);
    plane.point[a] = moments.mean[axis];
    plane.normal[a] = system.normal()[axis];
  }
  return plane;
}

} // namespace linelet::clustering
